/* SPDX-License-Identifier: MIT */
/*
 * Integer arithmetic for all of core: saturation, rounding shifts, leading zeros, long products,
 * roots and reciprocals. Internal.
 *
 * How a product or a quotient is formed depends on the core, its value never does:
 * - QTRI_LONG_MULTIPLY: 1 where 32 x 32 -> 64 bits is an instruction or two; 0 forms it of halves
 * - QTRI_DIVIDE: 1 where 32 / 32 bits is an instruction; 0 divides by a reciprocal
 *
 * They may be set from outside, as the tests do to run the narrow code on the host.
 * Functions that are long on a core of 32 bits, in shared.inc, are compiled once, in shared.c, with
 * QTRI_SHARE, otherwise inline in every file.
 */
#ifndef QTRI_BITS_H
#define QTRI_BITS_H

#include <stdbool.h>
#include <stdint.h>

#include "qtri/body/arithmetic.h"

/* Right shift of a signed value is arithmetic: every compiler we know; checked, not assumed. */
typedef char qtri_arithmetic_shift_required[(-1 >> 1) == -1 ? 1 : -1];

/* So is that a conversion to a signed type keeps the low bits. */
typedef char qtri_wrapping_conversion_required[(int32_t)0x80000000u == INT32_MIN ? 1 : -1];

/*
 * With QTRI_CHECK_MATH a result that does not fit and an argument outside the domain end here; see
 * qtri/q16.h. Without it nothing is tested.
 */
#ifdef QTRI_CHECK_MATH
#ifdef QTRI_MATH_FAULT
void QTRI_MATH_FAULT(void);
#else
static inline void qtri_math_fault(void)
{
#ifdef __GNUC__
    __builtin_trap();
#else
    for (;;) {
    }
#endif
}
#define QTRI_MATH_FAULT qtri_math_fault
#endif
#define QTRI_MATH_CHECK(condition) ((condition) ? (void)0 : QTRI_MATH_FAULT())
#else
#define QTRI_MATH_CHECK(condition) ((void)0)
#endif

/* A compiler barrier on x, in a register: GCC would interleave sums and products, and spill. */
#ifdef __GNUC__
#define QTRI_HOLD(x) __asm__ volatile("" : "+r"(x))
#else
#define QTRI_HOLD(x) ((void)(x))
#endif

/* Inlined by all its callers, for a small one in a loop or one whose choices they know. */
#ifdef __GNUC__
#define QTRI_INLINE __attribute__((always_inline)) static inline
#else
#define QTRI_INLINE static inline
#endif

/* A function of its own, whose stack is free again when it returns. */
#ifdef __GNUC__
#define QTRI_NOINLINE __attribute__((noinline))
#else
#define QTRI_NOINLINE
#endif

/*
 * For a function whose arguments a call would pass in memory: inlined wherever it is called; where
 * code is to be small, the compiler decides.
 */
#if defined(__GNUC__) && !defined(__OPTIMIZE_SIZE__)
#define QTRI_IN_PLACE __attribute__((always_inline)) static inline
#else
#define QTRI_IN_PLACE static inline
#endif

/* The largest or smallest int32_t, by the sign of x. */
static inline int32_t qtri_extreme32(int32_t x)
{
    return x < 0 ? INT32_MIN : INT32_MAX;
}

static inline int32_t qtri_saturate32(int64_t x)
{
    int32_t high = (int32_t)(x >> 32);
    int32_t low = (int32_t)(uint32_t)((uint64_t)x & UINT32_MAX);
    return high == (low < 0 ? -1 : 0) ? low : qtri_extreme32(high);
}

/* Saturates a result that was not meant to; see QTRI_CHECK_MATH. */
static inline int32_t qtri_saturate32_checked(int64_t x)
{
    QTRI_MATH_CHECK(x >= INT32_MIN && x <= INT32_MAX);
    return qtri_saturate32(x);
}

/* |x| as unsigned: right for INT32_MIN and INT64_MIN too. */
static inline uint32_t qtri_magnitude32(int32_t x)
{
    return x < 0 ? 0 - (uint32_t)x : (uint32_t)x;
}

static inline uint64_t qtri_magnitude64(int64_t x)
{
    return x < 0 ? 0 - (uint64_t)x : (uint64_t)x;
}

/* The value of the low 64 bits read as two's complement: sums that are meant to wrap. */
static inline int64_t qtri_wrap64(uint64_t x)
{
    return x > (uint64_t)INT64_MAX ? -(int64_t)(UINT64_MAX - x) - 1 : (int64_t)x;
}

/* x 2^n for a result that fits, 0 <= n < 64: compilers make a product of two long numbers of that
   where a shift of a negative one is not defined. */
static inline int64_t qtri_shift_left64(int64_t x, int32_t n)
{
    return qtri_wrap64((uint64_t)x << n);
}

/* x 2^n, rounded down, |n| < 32. */
static inline int32_t qtri_shift32(int32_t x, int32_t n)
{
    return n >= 0 ? (int32_t)((uint32_t)x << n) : x >> -n;
}

static inline int32_t qtri_least32(int32_t a, int32_t b)
{
    return a < b ? a : b;
}

static inline int32_t qtri_greatest32(int32_t a, int32_t b)
{
    return a > b ? a : b;
}

/* x clamped to low..high. */
static inline int32_t qtri_hold32(int32_t x, int32_t low, int32_t high)
{
    return x < low ? low : (x > high ? high : x);
}

#if QTRI_LONG_MULTIPLY
static inline uint64_t qtri_mul_u32(uint32_t a, uint32_t b)
{
    return (uint64_t)a * b;
}

static inline int64_t qtri_mul_s32(int32_t a, int32_t b)
{
    return (int64_t)a * b;
}
#endif

#if QTRI_SHARE
int64_t qtri_shift_round(int64_t x, int32_t shift);
int32_t qtri_clz64(uint64_t x);
#if !QTRI_LONG_MULTIPLY
uint64_t qtri_mul_u32(uint32_t a, uint32_t b);
int64_t qtri_mul_s32(int32_t a, int32_t b);
#endif
#else
#define QTRI_SHARED static inline
#include "shared.inc"
#endif

/* floor(a b / 2^32). */
static inline uint32_t qtri_mul_high32(uint32_t a, uint32_t b)
{
    return (uint32_t)(qtri_mul_u32(a, b) >> 32);
}

/* floor(a b / 2^64). */
uint64_t qtri_mul_high64(uint64_t a, uint64_t b);

/*
 * floor(n 2^more / divisor) modulo 2^64, for n < 2^62, 0 < divisor < 2^62 and more >= 0; *half:
 * what is left over is half of the divisor or more. In place of the compiler's functions, which are
 * longer and slower where there is no instruction that divides.
 */
uint64_t qtri_divide64(uint64_t n, uint64_t divisor, int32_t more, bool *half);

/* The square root, rounded down, x = root^2 + *remainder, and to nearest: halves cannot occur. */
uint32_t qtri_sqrt64_floor(uint64_t x, uint64_t *remainder);
uint64_t qtri_sqrt64_round(uint64_t x);

/* qtri_sqrt64_round() for x < 2^32, in less than half of the instructions. */
uint32_t qtri_sqrt32_round(uint32_t x);

/*
 * floor(2^62 / x) for x in [2^31, 2^32): the reciprocal of a normalised mantissa, in
 * (2^30, 2^31]; a power of two gives an exact one. x below 2^31 is taken as 2^31.
 */
uint32_t qtri_reciprocal_q62(uint32_t x);

/* n / divisor towards zero, as C has it: one function of the compiler's serves all divisions. */
static inline int32_t qtri_divide32(int32_t n, uint32_t divisor)
{
    const uint32_t quotient = qtri_magnitude32(n) / divisor;
    return (int32_t)(n < 0 ? 0 - quotient : quotient);
}

/* A word rotated right by the low five bits of `by`, which need no mask. */
static inline uint32_t qtri_rotated(uint32_t word, uint32_t by)
{
#if defined(__GNUC__) && defined(__thumb__) && !defined(__thumb2__)
#if defined(__clang__) || defined(__ARM_ASM_SYNTAX_UNIFIED__)
    __asm__("rors %0, %1" : "+l"(word) : "l"(by) : "cc");
#else /* GCC's syntax is divided, and a line to change it would count when it inlines */
    __asm__("ror %0, %1" : "+l"(word) : "l"(by) : "cc");
#endif
    return word;
#elif defined(__GNUC__) && defined(__thumb2__)
    __asm__("ror %0, %0, %1" : "+r"(word) : "r"(by));
    return word;
#else
    return word >> (by & 31) | word << ((0 - by) & 31);
#endif
}

/*
 * High words of products. A Cortex-M0+ multiplies 32 by 32 bits to 32: there the product is put
 * together from half-words, in 6 to 15 instructions where the compiler's 64-bit product takes 35.
 */

/* floor(a b / 2^32) for a, b <= 2^31. */
static inline uint32_t qtri_mul_high31(uint32_t a, uint32_t b)
{
#if QTRI_LONG_MULTIPLY
    return (uint32_t)(((uint64_t)a * b) >> 32);
#else
    uint32_t a_high = a >> 16; /* <= 2^15, and a_low = 0 where it is equal; b likewise */
    uint32_t b_high = b >> 16;
    uint32_t a_low = a & 0xFFFFu;
    uint32_t b_low = b & 0xFFFFu;
    uint32_t middle = a_high * b_low + a_low * b_high + ((a_low * b_low) >> 16); /* < 2^32 */
    return a_high * b_high + (middle >> 16);
#endif
}

/* floor(a b / 2^32) for |a| <= 2^30, 0 <= b < 2^30. */
static inline int32_t qtri_mul_high_s30(int32_t a, int32_t b)
{
#if QTRI_LONG_MULTIPLY
    return (int32_t)(qtri_mul_s32(a, b) >> 32);
#else
    int32_t a_high = a >> 16; /* |.| <= 2^14, and a_low = 0 where a is 2^30 */
    int32_t b_high = b >> 16; /* < 2^14 */
    int32_t a_low = (int32_t)qtri_low16((uint32_t)a);
    int32_t b_low = (int32_t)qtri_low16((uint32_t)b);
    int32_t carry = (int32_t)(((uint32_t)a_low * (uint32_t)b_low) >> 16);
    int32_t middle = a_high * b_low + a_low * b_high + carry; /* < 2^30 + 2^30 - 2^16 */
    return a_high * b_high + (middle >> 16);
#endif
}

/* floor(a b / 2^16) for b < 2^16. */
static inline uint32_t qtri_mul_high16(uint32_t a, uint32_t b)
{
#if QTRI_LONG_MULTIPLY
    return (uint32_t)(((uint64_t)a * (b << 16)) >> 32); /* the high word: no shift of two words */
#else
    return (a >> 16) * b + (((a & 0xFFFFu) * b) >> 16);
#endif
}

/* a b / 2^16 to nearest for b < 2^16. */
static inline uint32_t qtri_mul_round16(uint32_t a, uint32_t b)
{
#if QTRI_LONG_MULTIPLY
    return (uint32_t)(((uint64_t)a * (b << 16) + 0x80000000u) >> 32);
#else
    return (a >> 16) * b + (((a & 0xFFFFu) * b + 0x8000u) >> 16);
#endif
}

/* floor(a b / 2^12) modulo 2^32 for b <= 2^16. */
static inline uint32_t qtri_mul_wrap12(uint32_t a, uint32_t b)
{
#if QTRI_LONG_MULTIPLY
    return (uint32_t)(((uint64_t)a * b) >> 12);
#else
    return (((a >> 16) * b) << 4) + (((a & 0xFFFFu) * b) >> 12);
#endif
}

/* floor(a b / 2^16) for |b| < 2^15. */
static inline int32_t qtri_mul_s16(int32_t a, int32_t b)
{
#if QTRI_LONG_MULTIPLY
    return (int32_t)(qtri_mul_s32(a, b * 65536) >> 32); /* as qtri_mul_high16() */
#else
    return (a >> 16) * b + (((int32_t)qtri_low16((uint32_t)a) * b) >> 16);
#endif
}

/* floor(a b / 2^32) for |a| < 2^31, b <= 2^31. */
static inline int32_t qtri_mul_high_s31(int32_t a, uint32_t b)
{
#if QTRI_LONG_MULTIPLY
    return (int32_t)(((int64_t)a * b) >> 32);
#else
    int32_t a_high = a >> 16; /* |.| <= 2^15 */
    uint32_t a_low = qtri_low16((uint32_t)a);
    uint32_t b_high = b >> 16; /* <= 2^15 */
    uint32_t b_low = qtri_low16(b);
    int32_t cross = a_high * (int32_t)b_low + (int32_t)((a_low * b_low) >> 16); /* |.| < 2^31 */
    uint32_t cross_low = a_low * b_high + qtri_low16((uint32_t)cross);          /* < 2^32 */
    return a_high * (int32_t)b_high + (cross >> 16) + (int32_t)(cross_low >> 16);
#endif
}

/*
 * Calls a function that asserts on arguments, in checked builds, see qtri/error.h. Other builds do
 * not compile it.
 */

#ifdef QTRI_CHECKED
#define QTRI_CHECK(call) call
#else
#define QTRI_CHECK(call) ((void)0)
#endif

/* The least and the greatest of three. */
static inline void qtri_find_range(uint32_t *least, uint32_t *greatest, const uint32_t f[3])
{
    *least = f[0];
    *greatest = f[0];
    for (int i = 1; i < 3; i++) {
        *least = f[i] < *least ? f[i] : *least;
        *greatest = f[i] > *greatest ? f[i] : *greatest;
    }
}

/* ---- Reciprocals, and seeds of these and of roots ---- */

/*
 * First estimates of quotients and roots, of products that fit 32 bits. They are as good as 16 bits
 * allow; whoever uses them finds the exact remainder and corrects. The tests try every argument, of
 * both variants, against the bounds given here.
 */

/*
 * 2^31 / x for x in [2^15, 2^16]: in [2^15 - 1, 2^16], with 0 <= 2^31 - x seed < 5/4 x.
 * Without a division: with d = x / 2^16, the line 48/17 - 32/17 d is within 1/17 of 1/d. Newton's
 * step r (2 - d r) squares that error, which is then never positive; with 2 + 2/17^2 in place of 2
 * it is centred: 2^-9. The second step r + r (1 - d r) leaves 2^-18 and the rounding to Q15.
 */
static inline uint32_t qtri_reciprocal_seed_newton(uint32_t x)
{
    uint32_t r_q14 = 46260u - ((x * 30840u) >> 16);                   /* < 2^15 (1 + 1/17) */
    uint32_t r_q15 = (r_q14 * (131192u - ((x * r_q14) >> 14))) >> 15; /* Q14 Q16, < 2^31.1 */
    int32_t error_q31 = (int32_t)(0x80000000u - x * r_q15);           /* |error| < 2^22 */
    return r_q15 + (uint32_t)(((int32_t)r_q15 * (error_q31 >> 7)) >> 24);
}

/* qtri_reciprocal_seed_newton() or a division: within its bounds, but not equal on all cores. */
static inline uint32_t qtri_reciprocal_seed(uint32_t x)
{
#if QTRI_DIVIDE
    return 0x80000000u / x; // NOLINT(clang-analyzer-core.DivideZero): x is 2^15 or more
#else
    return qtri_reciprocal_seed_newton(x);
#endif
}

/* 1 / sqrt(v) in Q15 for v = t / 2^16, t in [2^14, 2^16): within 2^-13 of itself, <= 2^16 + 4. */
uint32_t qtri_rsqrt_seed(uint32_t t);

/*
 * qtri_rsqrt_seed() inline: a cubic with the least relative error on [1/4, 1], 2^-7.1, and Newton's
 * step y (3 - v y^2) / 2 with a 3 that centres the error as qtri_reciprocal_seed does.
 */
QTRI_IN_PLACE uint32_t qtri_rsqrt_seed_in_place(uint32_t t)
{
    uint32_t p_q13 = 51036u - ((19976u * t) >> 16);
    p_q13 = 48422u - ((p_q13 * t) >> 16);
    uint32_t y_q14 = 50993u - ((p_q13 * t) >> 15);           /* < 2^15 (1 + 2^-7) */
    uint32_t unit_q30 = ((y_q14 * y_q14) >> 14) * t;         /* v y^2, close to 1 */
    return (y_q14 * ((3221310472u - unit_q30) >> 15)) >> 15; /* Q14 Q16, < 2^31.1 */
}

/*
 * The largest r with r x < 2^62, for x in [2^31, 2^32): in [2^30, 2^31). It is the reciprocal
 * rounded down, except for 2^31, whose own would not fit an int32_t.
 */
static inline int32_t qtri_reciprocal_below(uint32_t x)
{
#if QTRI_LONG_MULTIPLY && QTRI_DIVIDE
    /*
     * With d = x / 2^32, s = 1 / d within 2^-15: s (2 - d s) is never more than 1 / d, and at most
     * 2^-30 less; products cut off twice make it less than 4 units.
     */
    uint32_t s_q31 = (0x7FFFFFFFu / (x >> 16)) << 16;
    uint32_t two_less_q31 = ~qtri_mul_high32(x, s_q31);
    uint32_t r = qtri_mul_high32(s_q31, two_less_q31);
    uint64_t rest = ((uint64_t)1 << 62) - (uint64_t)x * r;
    while (rest > x) {
        rest -= x;
        r++;
    }
#else
    uint32_t r = qtri_reciprocal_q62(x);
    r -= r >> 31;
#endif
    int32_t reciprocal = (int32_t)r;
    QTRI_HOLD(reciprocal); /* signed, or GCC 12 forgets what smull is for */
    return reciprocal;
}

/*
 * 2^62 / x within 4 units, for x in [2^31, 2^32): the same number on all cores, as nothing corrects
 * it. The seed is off by 5/4 of 2^-15 of itself at most, and a Newton step squares
 * that: 2^-29.4 of a reciprocal of up to 2^31 is less than 3 units; cut-off bits are one.
 */
static inline uint32_t qtri_reciprocal_near(uint32_t x)
{
    uint32_t r_q15 = qtri_reciprocal_seed_newton(x >> 16);
    uint32_t unit_q31 = qtri_mul_high16(x, r_q15);
    int32_t error_q31 = (int32_t)(0x80000000u - unit_q31); /* see qtri_reciprocal_q62 */
    return (r_q15 << 15) + (uint32_t)(((error_q31 >> 1) * (int32_t)r_q15) >> 15);
}

/* floor(2^31 / x) for x in [2^15, 2^16]. */
static inline uint32_t qtri_reciprocal_q31(uint32_t x)
{
    uint32_t y = qtri_reciprocal_seed(x);
#if !QTRI_DIVIDE
    int32_t rest = (int32_t)(0x80000000u - x * y); /* of every x the seed leaves 0..5/4 x */
    while (rest >= (int32_t)x) {
        rest -= (int32_t)x;
        y++;
    }
#endif
    return y;
}

/* Shifts to the left, or else right, for x 2^up, up < 32; and x 2^up by them, without a branch. */
static inline void qtri_set_shifts(uint8_t *left, uint8_t *right, int32_t up)
{
    *left = (uint8_t)(up > 0 ? up : 0);
    *right = (uint8_t)(up < 0 ? qtri_least32(-up, 31) : 0);
}

static inline uint32_t qtri_both_shifts(int32_t x, uint8_t left, uint8_t right)
{
    return (uint32_t)((int32_t)((uint32_t)x << left) >> right);
}

#endif
