/* SPDX-License-Identifier: MIT */
#include "qtri/q16_trig.h"

#include "atan.h"
#include "../bits/bits.h"
#include "coefficients.h"
#include "../bits/multiply.h"

#define ATAN_HALF_Q32 633866811u  /* atan(1/2) / pi 2^32 */
#define PI_Q29        1686629713u /* pi 2^29 */

/*
 * 1/D - 1 in Q16 for D = d_q16 / 2^16 in [1/2, 1], less than 2^-14 too small.
 *
 * r = 48/17 - 32/17 D is 1/D within 1/17; each of Newton's steps r += r (1 - D r) squares that:
 * 2^-8.1, then 2^-16 from below.
 */
static inline uint32_t reciprocal_less_one_q16(uint32_t d_q16)
{
    uint32_t r_q14 = 46261u - ((d_q16 * 30840u) >> 16); /* < 2^15 */
    int32_t error_q30 = 0x40000000 - (int32_t)(d_q16 * r_q14);
    r_q14 <<= 2; /* from here in Q16 */
    uint32_t r_q16 = r_q14 + (uint32_t)(((int32_t)r_q14 * (error_q30 >> 16)) >> 14);
    int32_t error_q32 = (int32_t)(0u - d_q16 * r_q16); /* |1 - D r| < 2^-8: 2^32 wraps */
    r_q16 += (uint32_t)(((int32_t)r_q16 * (error_q32 >> 11)) >> 21);
    return r_q16 - (r_q16 < 0x10000u ? r_q16 : 0x10000u); /* r is in [1, 2) */
}

/*
 * n / d in Q32, at most 2^-28 of itself too small, for n <= d / 2 and d >= 2^31: the last of
 * Newton's steps is done on n r. D = d / 2^32 is taken too large, which costs r at most 2^-15 and
 * leaves an error that is not negative: < 2^-14.
 */
static uint32_t quotient_q32(uint32_t n, uint32_t d)
{
    uint32_t r_q16 = reciprocal_less_one_q16((d >> 16) + 1); /* of 2^15..2^16; one is added below */
    uint32_t rest_q32 = 0u - (d + qtri_mul_high16(d, r_q16));
    uint32_t q_q32 = n + qtri_mul_high16(n, r_q16);
    return q_q32 + (qtri_mul_high16(q_q32, rest_q32 >> 2) >> 14);
}

/*
 * With the shorter side n and the longer one d, n / d in [0, 1]: from 5/16 up the angle is
 * atan(1/2) + atan((n - d/2) / (d + n/2)), whose quotient is in [-1/6, 1/3].
 */
uint32_t qtri_angle_q31(uint32_t y, uint32_t x, bool mirrored)
{
    uint32_t n = y < x ? y : x;
    uint32_t d = y < x ? x : y;
    if (d == 0) {
        return 0;
    }
    int32_t zeros = qtri_clz32(d);
    n <<= zeros;
    d <<= zeros; /* in [2^31, 2^32) */
    uint32_t base_q32 = 0;
    bool below = false;
    if (n > (d >> 2) + (d >> 4)) {
        uint32_t half = d >> 1;
        base_q32 = ATAN_HALF_Q32;
        below = n < half;
        d = half + (n >> 2); /* halves: d + n / 2 would not fit */
        n = (below ? half - n : n - half) >> 1;
        if (d < 0x80000000u) {
            d <<= 1;
            n <<= 1;
        }
    }
    uint32_t q_q32 = quotient_q32(n, d);
    uint32_t v_q32 = qtri_mul_high31(q_q32, q_q32);
    uint32_t v_q19 = v_q32 >> 13;                                       /* < 2^16 */
    uint32_t sum = QTRI_ATAN_3_Q20 - ((QTRI_ATAN_4_Q20 * v_q19) >> 19); /* < 2^16 */
    sum = QTRI_ATAN_2_Q34 - ((sum * v_q19) >> 5);
    sum = QTRI_ATAN_1_Q34 - qtri_mul_high31(v_q32, sum);
    sum = QTRI_ATAN_0_Q32 - (qtri_mul_high31(v_q32, sum) >> 2);
    uint32_t angle_q32 = qtri_mul_high31(q_q32, sum);
    angle_q32 = below ? base_q32 - angle_q32 : base_q32 + angle_q32;
    if (y > x) {
        angle_q32 = 0x80000000u - angle_q32;
    }
    uint32_t angle_q31 = (angle_q32 + 1) >> 1;
    return mirrored ? 0x80000000u - angle_q31 : angle_q31;
}

q16 qtri_half_turns_to_radians(uint32_t angle_q31)
{
    return (q16)((qtri_mul_high31(angle_q31, PI_Q29) + 0x800u) >> 12); /* from Q28 */
}

q16 q16_atan2(q16 y, q16 x)
{
    q16 angle =
        qtri_half_turns_to_radians(qtri_angle_q31(qtri_magnitude32(y), qtri_magnitude32(x), x < 0));
    return y < 0 ? -angle : angle;
}

q16 q16_atan2_deg(q16 y, q16 x)
{
    q16 angle =
        qtri_half_turns_to_degrees(qtri_angle_q31(qtri_magnitude32(y), qtri_magnitude32(x), x < 0));
    return y < 0 ? -angle : angle;
}
