/* SPDX-License-Identifier: MIT */
/*
 * Sums and products of Q16.16, and what rounds them.
 */
#include "qtri/q16.h"

#include "../bits/bits.h"

/* The low 32 bits of a + b; *over: the sum does not fit, which is when its sign is neither's. */
static q16 sum(q16 a, q16 b, bool *over)
{
#if defined(__GNUC__) && __GNUC__ >= 5
    q16 low;
    *over = __builtin_add_overflow(a, b, &low);
    return low;
#else
    q16 low = q16_add_wrap(a, b);
    *over = ((a ^ low) & (b ^ low)) < 0;
    return low;
#endif
}

static q16 difference(q16 a, q16 b, bool *over)
{
#if defined(__GNUC__) && __GNUC__ >= 5
    q16 low;
    *over = __builtin_sub_overflow(a, b, &low);
    return low;
#else
    q16 low = q16_sub_wrap(a, b);
    *over = ((a ^ b) & (a ^ low)) < 0;
    return low;
#endif
}

q16 q16_add(q16 a, q16 b)
{
    bool over;
    q16 low = sum(a, b, &over);
    QTRI_MATH_CHECK(!over);
    return over ? qtri_extreme32(a) : low;
}

q16 q16_sub(q16 a, q16 b)
{
    bool over;
    q16 low = difference(a, b, &over);
    QTRI_MATH_CHECK(!over);
    return over ? qtri_extreme32(a) : low;
}

q16 q16_neg(q16 x)
{
    QTRI_MATH_CHECK(x != Q16_MIN);
    return x == Q16_MIN ? Q16_MAX : -x;
}

q16 q16_abs(q16 x)
{
    QTRI_MATH_CHECK(x != Q16_MIN);
    return x >= 0 ? x : (x == Q16_MIN ? Q16_MAX : -x);
}

/*
 * a b / 2^16, to nearest, halves up, or cut off: the low 32 bits, and whether they are all. *size
 * has the sign of what does not fit.
 */
enum rounding { CUT_OFF, NEAREST };

#if QTRI_LONG_MULTIPLY
static inline bool product(q16 a, q16 b, enum rounding rounding, q16 *low, int32_t *size)
{
    int64_t exact = qtri_mul_s32(a, b) + (rounding == NEAREST ? 0x8000 : 0); /* <= 2^62 + 2^15 */
    int32_t high = (int32_t)(exact >> 32);
    *low = (q16)(uint32_t)(((uint64_t)exact >> 16) & UINT32_MAX);
    *size = high;
    return high == *low >> 16; /* bits 15..31 of high are alike */
}
#else
/* a + b / 2^16, halves up. A right shift leaves the last bit shifted out in the carry. */
static inline int32_t add_rounded(int32_t a, uint32_t b)
{
#if defined(__GNUC__) && defined(__thumb__) && !defined(__thumb2__)
    __asm__(".syntax unified\n\tlsrs %0, %0, #16\n\tadcs %0, %1" : "+l"(b) : "l"(a) : "cc");
    return (int32_t)b;
#else
    return a + (int32_t)(((b >> 15) + 1) >> 1);
#endif
}

/*
 * Of half-words, the low ones unsigned: a b / 2^16 = a_high b_high 2^16 + a_high b_low +
 * a_low b_high + a_low b_low / 2^16. The upper half of the sum is that of its terms, *size, or one
 * more by a carry; it fits 16 bits if the upper half of the low word is one of the two.
 */
static inline bool product(q16 a, q16 b, enum rounding rounding, q16 *low, int32_t *size)
{
    int32_t a_low = (int32_t)qtri_low16((uint32_t)a);
    int32_t a_high = a >> 16;
    int32_t b_low = (int32_t)qtri_low16((uint32_t)b);
    int32_t b_high = b >> 16;
    uint32_t lowest = (uint32_t)a_low * (uint32_t)b_low;
    int32_t cross = a_high * b_low;
    int32_t first = /* in [-2^31 + 2^15, 2^31 - 2^15] */
        rounding == NEAREST ? add_rounded(cross, lowest) : cross + (int32_t)(lowest >> 16);
    int32_t second = a_low * b_high; /* likewise */
    int32_t upper = a_high * b_high; /* <= 2^30 */
    uint32_t word = ((uint32_t)upper << 16) + (uint32_t)first + (uint32_t)second;
    *low = (q16)word;
    *size = upper + (first >> 16) + (second >> 16);
    return (uint32_t)((*low >> 16) - *size) <= 1;
}
#endif

static inline q16 saturated_product(q16 a, q16 b, enum rounding rounding, bool meant)
{
    q16 low;
    int32_t size;
    if (!product(a, b, rounding, &low, &size)) {
        QTRI_RARELY();
        (void)meant; /* for the check alone */
        QTRI_MATH_CHECK(meant);
        return qtri_extreme32(size);
    }
    return low;
}

q16 q16_mul(q16 a, q16 b)
{
    return saturated_product(a, b, NEAREST, false);
}

q16 q16_mul_floor(q16 a, q16 b)
{
    return saturated_product(a, b, CUT_OFF, false);
}

q16 q16_mul_wrap(q16 a, q16 b)
{
    q16 low;
    int32_t size;
    (void)product(a, b, NEAREST, &low, &size);
    return low;
}

/* |(b - a) t| <= (2^32 - 1) 2^31, and the product is in Q32. */
static inline q16 lerp_by(q16 a, int64_t step_q32)
{
    return qtri_saturate32_checked(a + ((step_q32 + 0x8000) >> 16));
}

q16 q16_lerp(q16 a, q16 b, q16 t)
{
    bool over;
    q16 span = difference(b, a, &over);
    if (over) {
        QTRI_RARELY();
        return lerp_by(a, qtri_mul_s32(b, t) - qtri_mul_s32(a, t));
    }
    return lerp_by(a, qtri_mul_s32(span, t));
}

/* The largest integer is 0x7FFF0000. */
static q16 integer_below(q16 x, q16 bias)
{
    bool over;
    q16 low = sum(x, bias, &over);
    QTRI_MATH_CHECK(!over);
    return over ? Q16_MAX : q16_floor(low);
}

q16 q16_ceil(q16 x)
{
    return integer_below(x, 0xFFFF);
}

q16 q16_round(q16 x)
{
    return integer_below(x, 0x8000);
}

#ifdef QTRI_CHECK_MATH
q16 q16_add_sat(q16 a, q16 b)
{
    bool over;
    q16 low = sum(a, b, &over);
    return over ? qtri_extreme32(a) : low;
}

q16 q16_sub_sat(q16 a, q16 b)
{
    bool over;
    q16 low = difference(a, b, &over);
    return over ? qtri_extreme32(a) : low;
}

q16 q16_mul_sat(q16 a, q16 b)
{
    return saturated_product(a, b, NEAREST, true);
}
#endif
