/* SPDX-License-Identifier: MIT */
#include "qtri/q16.h"

#include "../bits/bits.h"

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
    if (sign < 0) {
        return quotient >= 0x80000000u ? Q16_MIN : -(q16)quotient;
    }
    QTRI_MATH_CHECK(quotient <= (uint32_t)Q16_MAX);
    return quotient > (uint32_t)Q16_MAX ? Q16_MAX : (q16)quotient;
}
