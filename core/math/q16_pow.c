/* SPDX-License-Identifier: MIT */
#include "qtri/q16_exp.h"

#include "../bits/bits.h"
#include "coefficients.h"
#include "exp2.h"
#include "../bits/multiply.h"

#define ROOT_2_Q31 3037000500u

/*
 * log2(x) in Q43 for x > 0, within 2^-29.8 of itself and half a unit: the exponent multiplies the
 * first until it is 2^-27.6 of a result of 64, .018 ULP, and the second by up to 2^15.
 * x = 2^e m with m in [sqrt(1/2), sqrt(2)], s = (m - 1) / (m + 1), log2(m) = s (2/ln 2 + ...).
 */
static int64_t precise_log2_q43(uint32_t x)
{
    int32_t zeros = qtri_clz32(x);
    uint32_t m = x << (zeros & 31); /* Q31 in [1, 2), or Q32 in [1/2, 1) */
    int32_t exponent = 15 - zeros;
    bool below = m > ROOT_2_Q31;
    uint32_t one = below ? 0 : 0x80000000u; /* modulo 2^32 */
    uint32_t difference = below ? one - m : m - one;
    int64_t log_q43 = 0;
    if (difference != 0) { /* then it is 2 or more */
        uint32_t half_sum = (m >> 1) + (below ? 0x80000000u : 0x40000000u); /* in (2^31, 2^32) */
        int32_t up = qtri_clz32(difference);                                /* 1..30 */
        int32_t shift = 32 + up;
        /* The reciprocal, rounded down and below 2^31, and half of its last place. */
        uint32_t reciprocal_q63 = 2 * qtri_reciprocal_q62(half_sum) + 1;
        uint32_t s = qtri_mul_high32(difference << up, reciprocal_q63); /* >= 2^30 */
        uint32_t s_q32 = s >> up;                                       /* < .1716 */
        uint32_t v_q32 = qtri_mul_high31(s_q32, s_q32);                 /* < 2^27 */
        uint32_t sum = QTRI_LOG2S_3_Q32 + (v_q32 >> 16) * QTRI_LOG2S_4_Q16;
        sum = QTRI_LOG2S_2_Q32 + qtri_mul_high32(v_q32, sum);
        sum = QTRI_LOG2S_1_Q32 + qtri_mul_high32(v_q32, sum);
        sum = QTRI_LOG2S_0_Q30 + ((qtri_mul_high32(v_q32, sum) + 3) >> 2); /* v is rounded down */
        /* (s + 1/2) sum < 2^63.6: s was rounded down. */
        uint64_t log = qtri_mul_u32(s, sum) + (sum >> 1);
        log_q43 = (int64_t)((log + ((uint64_t)1 << (shift - 14))) >> (shift - 13));
    }
    return (exponent + below) * ((int64_t)1 << 43) + (below ? -log_q43 : log_q43);
}

q16 q16_pow(q16 x, q16 y)
{
    if (y == 0) {
        return Q16_ONE;
    }
    if (x == 0) {
        QTRI_MATH_CHECK(y > 0);
        return y > 0 ? 0 : Q16_MAX;
    }
    bool negative = false;
    if (x < 0) {
        QTRI_MATH_CHECK((y & 0xFFFF) == 0);
        if ((y & 0xFFFF) != 0) {
            return 0;
        }
        negative = (y >> 16) & 1;
    }
    q16 size = qtri_exp2_product(y, precise_log2_q43(qtri_magnitude32(x)));
    if (!negative) {
        return size;
    }
    return size == Q16_MAX ? Q16_MIN : -size;
}
