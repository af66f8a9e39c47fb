/* SPDX-License-Identifier: MIT */
/*
 * Quotients of Q16.16. All of them estimate digits by a short reciprocal, from below, and correct
 * by the remainder, which is exact.
 */
#include "qtri/q16.h"

#include "../bits/bits.h"
#include "../bits/seed.h"

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

#ifdef QTRI_CHECK_MATH
q16 q16_div_sat(q16 a, q16 b)
{
    if (b == 0) {
        return quotient_by_zero(a);
    }
    return divided(a, b, true);
}
#endif
