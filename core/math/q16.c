/* SPDX-License-Identifier: MIT */
/*
 * Q16.16 scalars: sums, products, quotients, roots, conversions.
 */
#include "qtri/q16.h"

#include "../bits/bits.h"

/*
 * Sums and products of Q16.16, and what rounds them.
 */

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

/*
 * Q16.16 from and to integers and other fixed-point formats.
 */

/* value 2^shift, correctly rounded, halves up, saturated. */
QTRI_NOINLINE static int32_t shifted(int32_t value, int shift)
{
    if (shift < 0) {
        if (shift <= -32) {
            return 0; /* at least -1/2, less than 1/2 */
        }
        int32_t twice = value >> (-shift - 1);
        return (twice >> 1) + (twice & 1);
    }
    int32_t limit = shift < 32 ? (int32_t)((uint32_t)INT32_MAX >> shift) : 0;
    bool fits = value <= limit && value >= (shift < 32 ? -limit - 1 : 0);
    QTRI_MATH_CHECK(fits);
    return fits ? (int32_t)((uint32_t)value << (shift & 31)) : qtri_extreme32(value);
}

q16 q16_from_fixed(int32_t value, int fraction_bits)
{
    return shifted(value,
                   fraction_bits < -64 ? 80 : 16 - (fraction_bits > 64 ? 64 : fraction_bits));
}

int32_t q16_to_fixed(q16 x, int fraction_bits)
{
    return shifted(x, fraction_bits > 64 ? 48 : (fraction_bits < -64 ? -80 : fraction_bits - 16));
}

q16 q16_from_int(int32_t x)
{
    return shifted(x, 16);
}

/*
 * Quotients of Q16.16. All of them estimate digits by a short reciprocal, from below, and correct
 * by the remainder, which is exact.
 */

#define QUOTIENT_OVER UINT32_MAX

/* Exact halves go up. For b >= 2^28, where a remainder of several b has no room. Quotient <= 2^20.
 */
static uint32_t quotient_by_large(uint32_t a, uint32_t b)
{
    uint32_t quotient = 0;
    while (a >= b) { /* at most 8 times */
        a -= b;
        quotient++;
    }
    for (int bit = 0; bit < 16; bit++) { /* a < b <= 2^31 */
        a <<= 1;
        quotient <<= 1;
        if (a >= b) {
            a -= b;
            quotient++;
        }
    }
    return quotient + (a >= b - a);
}

/*
 * a 2^16 / b to nearest, halves up, for a, b <= 2^31, b > 0; QUOTIENT_OVER if it is 2^31 or more
 * before it is rounded.
 *
 * Two digits to the base 2^16, the second of the remainder of the first plus b / 2: what is cut off
 * there is the quotient rounded. (b odd: there are no halves, and the half less does not matter.)
 */
static inline uint32_t quotient_q16(uint32_t a, uint32_t b)
{
    if (a >> 15 >= b) {
        return QUOTIENT_OVER;
    }
    if (b >> 28 != 0) {
        return quotient_by_large(a, b);
    }
    int32_t zeros = qtri_clz32(b);
    uint32_t x = ((b << zeros) >> 16) + 1; /* above b's mantissa, so that estimates are below */
#if QTRI_DIVIDE
    uint32_t whole = a / b;
    uint32_t rest = a - whole * b;
    uint32_t digit = (rest << zeros) / x; /* 2 too small at most: n / d - n / (d + 1), n < 2^16 d */
#else
    uint32_t seed = qtri_reciprocal_seed(x);
    uint32_t whole = ((a >> (31 - zeros)) * seed) >> 16;
    uint32_t rest = a - whole * b;
    while (rest >= b) {
        rest -= b;
        whole++;
    }
    uint32_t digit = (((rest << zeros) >> 16) * seed) >> 15;
#endif
    uint32_t over =
        (rest << 16) + (b >> 1) - digit * b; /* modulo 2^32; < 2^32 by the bounds above */
    while (over >= b) {
        over -= b;
        digit++;
    }
    return (whole << 16) + digit;
}

/* The quotient with its sign, saturated. */
static inline q16 with_sign(uint32_t quotient, int32_t sign, bool meant)
{
    (void)meant; /* for the check alone */
    if (sign < 0) {
        QTRI_MATH_CHECK(quotient <= 0x80000000u || meant);
        return quotient >= 0x80000000u ? Q16_MIN : -(q16)quotient;
    }
    QTRI_MATH_CHECK(quotient <= (uint32_t)Q16_MAX || meant);
    return quotient > (uint32_t)Q16_MAX ? Q16_MAX : (q16)quotient;
}

static q16 quotient_by_zero(q16 a)
{
    return a == 0 ? 0 : qtri_extreme32(a);
}

static inline q16 divided(q16 a, q16 b, bool meant)
{
    uint32_t size_a = qtri_magnitude32(a);
    uint32_t size_b = qtri_magnitude32(b);
    bool exact = (a ^ b) < 0 && size_a == (uint64_t)size_b << 15; /* -2^31 fits */
    return with_sign(quotient_q16(size_a, size_b), a ^ b, meant || exact);
}

q16 q16_div(q16 a, q16 b)
{
    if (b == 0) {
        QTRI_MATH_CHECK(false);
        return quotient_by_zero(a);
    }
    return divided(a, b, false);
}

q16 q16_mod(q16 a, q16 b)
{
    if (b == 0) {
        QTRI_MATH_CHECK(false);
        return a;
    }
    if (b == -1) {
        return 0; /* INT32_MIN % -1 is not defined */
    }
    q16 rest = a % b;
    return rest != 0 && (rest ^ b) < 0 ? rest + b : rest;
}

q16 q16_div_sat(q16 a, q16 b)
{
    if (b == 0) {
        return quotient_by_zero(a);
    }
    return divided(a, b, true);
}

/*
 * Divisions under other names; apart from q16_div, which they would be made copies of.
 */

q16 q16_from_ratio(int32_t numerator, int32_t denominator)
{
    return q16_div(numerator, denominator);
}

q16 q16_recip(q16 x)
{
    return x == 0 ? q16_div(1, 0) : q16_div(Q16_ONE, x);
}

/*
 * With d = |c| normalised to 32 bits and n = |a b| scaled alike, n < 2^31 d where the quotient
 * fits, floor(n / 2^31) floor(2^62 / d) / 2^31 is less than n / d by less than 1 + 2 + 1. The
 * remainder starts from n + d / 2: what is cut off then is the quotient rounded, halves up.
 */
q16 q16_muldiv(q16 a, q16 b, q16 c)
{
    int64_t product = qtri_mul_s32(a, b);
    uint64_t n = qtri_magnitude64(product); /* <= 2^62 */
    uint32_t d = qtri_magnitude32(c);
    int32_t sign = (int32_t)(product >> 32) ^ c;
    if (n >> 31 >= d) { /* also for c = 0 */
        bool exact = c != 0 && sign < 0 && n == (uint64_t)d << 31;
        QTRI_MATH_CHECK(exact);
        (void)exact;
        return n == 0 ? 0 : qtri_extreme32(sign);
    }
    int32_t zeros = qtri_clz32(d);
    n <<= zeros;
    d <<= zeros;
    uint32_t quotient = (uint32_t)(qtri_mul_u32((uint32_t)(n >> 31), qtri_reciprocal_q62(d)) >> 31);
    uint64_t over = n + (d >> 1) - qtri_mul_u32(quotient, d);
    while (over >= d) {
        over -= d;
        quotient++;
    }
    return with_sign(quotient, sign, false);
}

/*
 * Roots of Q16.16.
 *
 * x is normalised by an even number of zeros to m in [2^30, 2^32), v = m / 2^32. The seed y is
 * 1 / sqrt(v) to 13 bits; one step of Newton's makes 24 of them, and the exact remainder decides.
 */

/*
 * sqrt(x 2^16) = r 2^(8 - zeros/2), r = sqrt(m). s = v y 2^16 is r less e, |e| < 9; the step
 * m - s^2 = e (2 r - e), times y / 2^17, adds e. With e^2 / 2 r, e times y's error and what is cut
 * off, s_24 - 256 r is in (-1.5, .2): the root, rounded, is off by 1 at most.
 */
q16 q16_sqrt(q16 x)
{
    if (x <= 0) {
        QTRI_MATH_CHECK(x == 0);
        return 0;
    }
    int32_t zeros = qtri_clz32((uint32_t)x) & ~1;
    uint32_t m = (uint32_t)x << zeros;
    uint32_t y_q15 = qtri_rsqrt_seed(m >> 16);
    uint32_t s = ((m >> 16) * y_q15) >> 15;
    int32_t step = ((int32_t)(m - s * s) >> 5) * (int32_t)y_q15; /* < 2^(20 - 5 + 16) */
    uint32_t s_24 = (s << 8) + (uint32_t)(step >> 19);
    uint32_t root = (s_24 + (((uint32_t)1 << (zeros >> 1)) >> 1)) >> (zeros >> 1);

    /* (r + 1/2)^2 = r^2 + r + 1/4. The remainder is exact: modulo 2^32, and less than 2^26. */
    int32_t remainder = (int32_t)(((uint32_t)x << 16) - root * root);
    if (remainder > (int32_t)root) {
        root++;
    } else if (remainder <= -(int32_t)root) {
        root--;
    }
    return (q16)root;
}

/*
 * 2^24 / sqrt(x) = y 2^(8 + zeros/2), and with y in Q30 y_q30 / 2^(22 - zeros/2). With a seed of
 * error d < 2^-13.6, Newton's step y + y (1 - v y^2) / 2 is too small by 3/2 d^2, at most 19 units
 * of Q30, what is cut off takes 8 more: -28 < y_q30 - y <= 1. If both ends round alike that is the
 * result; else the greater one, r, is too large if (2 r - 1)^2 x > 2^50, which it never equals.
 */
q16 q16_rsqrt(q16 x)
{
    if (x <= 0) {
        QTRI_MATH_CHECK(false);
        return Q16_MAX;
    }
    int32_t zeros = qtri_clz32((uint32_t)x) & ~1;
    uint32_t m = (uint32_t)x << zeros;
    uint32_t y_q15 = qtri_rsqrt_seed(m >> 16);
    int32_t error_q30 = (int32_t)(0x40000000u - qtri_mul_high32(m, y_q15 * y_q15)); /* < 2^18 */
    uint32_t y_q30 = (y_q15 << 15) + (uint32_t)(((error_q30 >> 3) * (int32_t)y_q15) >> 13);

    int32_t shift = 22 - (zeros >> 1); /* 7..22 */
    uint32_t half = ((uint32_t)1 << shift) >> 1;
    uint32_t least = (y_q30 + half - 1) >> shift;
    uint32_t most = (y_q30 + half + 28) >> shift;
    if (least != most) {
        uint64_t square = qtri_mul_u32(2 * most - 1, 2 * most - 1); /* <= 2^50 */
        uint32_t high = qtri_mul_high32((uint32_t)(square & UINT32_MAX), (uint32_t)x) +
                        (uint32_t)(square >> 32) * (uint32_t)x; /* of a product below 2^51 */
        return (q16)(high >> 18 != 0 ? least : most);
    }
    return (q16)least;
}

/* a^2 + b^2 <= 2^63, in units of (1/65536)^2: its root is in ULP. */
q16 q16_hypot(q16 a, q16 b)
{
    uint64_t root = qtri_sqrt64_round((uint64_t)qtri_mul_s32(a, a) + (uint64_t)qtri_mul_s32(b, b));
    QTRI_MATH_CHECK(root <= (uint64_t)Q16_MAX);
    return root > (uint64_t)Q16_MAX ? Q16_MAX : (q16)root;
}
