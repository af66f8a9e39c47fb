/* SPDX-License-Identifier: MIT */
/*
 * Powers and logarithms.
 */
#include "qtri/q16.h"

#include "../bits/bits.h"
#include "coefficients.h"

/* ---- Powers of two and of e ---- */

#define LOG2_E_Q43 12690079782337
#define LN2_Q16    45426u

/* 2^v - 1 in Q32 for v in [0, 1): products with the 16 bits of v are exact but for the floor. */
static uint32_t power_q32(uint32_t v_q16)
{
    uint32_t sum = QTRI_EXP2_7_Q35;
    sum = QTRI_EXP2_6_Q35 + qtri_mul_high16(sum, v_q16);
    sum = QTRI_EXP2_5_Q35 + qtri_mul_high16(sum, v_q16);
    sum = QTRI_EXP2_4_Q35 + qtri_mul_high16(sum, v_q16);
    sum = QTRI_EXP2_3_Q35 + qtri_mul_high16(sum, v_q16);
    sum = QTRI_EXP2_2_Q35 + qtri_mul_high16(sum, v_q16);
    sum = QTRI_EXP2_1_Q33 + (qtri_mul_round16(sum, v_q16) >> 2);
    sum = QTRI_EXP2_0_Q33 + qtri_mul_round16(sum, v_q16); /* what exceeds v / 2 */
    return (v_q16 << 15) + ((qtri_mul_round16(sum, v_q16) + 1) >> 1);
}

/* (1 + p) 2^exponent to nearest; exponent < 15. */
static q16 scaled(uint32_t p_q32, int32_t exponent)
{
    if (exponent < -17) {
        return 0;
    }
    uint32_t twice = (0x80000000u | (p_q32 >> 1)) >> (14 - exponent); /* floor(2 result) */
    uint32_t result = (twice >> 1) + (twice & 1);
    QTRI_MATH_CHECK(result <= (uint32_t)Q16_MAX);
    return result > (uint32_t)Q16_MAX ? Q16_MAX : (q16)result;
}

q16 q16_exp2(q16 x)
{
    int32_t exponent = x >> 16;
    if (exponent >= 15) {
        QTRI_MATH_CHECK(false);
        return Q16_MAX;
    }
    return scaled(power_q32((uint32_t)x & 0xFFFFu), exponent);
}

/*
 * 2^(factor log) for a log in [-16, 16) in Q43; errors as q16_exp.
 *
 * 2^(v + w) = 2^v (1 + w ln 2 + ...) for w < 2^-16: the next term is below 2^-34. With the largest
 * w what is added grows with v; to 0xFFFE9D1C, of the largest v, it is 0x162E3: the sum is 2^32 - 1
 * at most, and less of any other v (all were tried).
 */
static q16 exp2_product(q16 factor, int64_t log_q43)
{
    int64_t x_q43 = qtri_mul_s32(factor, (int32_t)(log_q43 >> 16)) +
                    (qtri_mul_s32(factor, (int32_t)(log_q43 & 0xFFFF)) >> 16); /* <= 2^62 */
    int64_t exponent = x_q43 >> 43;
    if (exponent >= 15) {
        QTRI_MATH_CHECK(false);
        return Q16_MAX;
    }
    if (exponent < -17) {
        return 0;
    }
    uint32_t v_q16 = (uint32_t)(x_q43 >> 27) & 0xFFFFu;
    uint32_t w_q43 = (uint32_t)x_q43 & 0x7FFFFFFu;
    uint32_t p_q32 = power_q32(v_q16);
    uint32_t w_q32 = (qtri_mul_high16(w_q43 << 5, LN2_Q16) + 0x8000u) >> 16;
    uint32_t more_q32 = w_q32 + ((qtri_mul_high16(p_q32, w_q32) + 0x8000u) >> 16);
    return scaled(p_q32 + more_q32, (int32_t)exponent);
}

q16 q16_exp(q16 x)
{
    return exp2_product(x, LOG2_E_Q43);
}

/* ---- Logarithms ---- */

#define LN2_Q31 1488522236u

static const uint32_t log2_of_factor_q31[16] = QTRI_LOG2_OF_FACTORS_Q31;
static const uint32_t factor_q16[16] = QTRI_LOG2_FACTORS_Q16;

/*
 * log2(x) for x > 0 in Q26. With x = 2^e m and m in [1, 2), a factor f of 16 bits, chosen by the
 * first four bits of m, leaves m f = 1 + v with v in [0, 1/16]; v loses bits below Q35 only.
 */
static int32_t log2_q26(uint32_t x)
{
    int32_t zeros = qtri_clz32(x);
    uint32_t m_q31 = x << zeros;
    uint32_t i = (m_q31 >> 27) & 15;
    uint32_t v_q35 = qtri_mul_wrap12(m_q31, factor_q16[i]); /* the 1 is beyond the 32 bits */
    uint32_t sum = QTRI_LOG2_1_Q31 - (qtri_mul_high31(v_q35, QTRI_LOG2_2_Q32) >> 4);
    sum = QTRI_LOG2_0_Q30 - (qtri_mul_high31(v_q35, sum) >> 4);
    uint32_t log_q31 = log2_of_factor_q31[i] + (qtri_mul_high31(v_q35, sum) >> 2);
    return (15 - zeros) * 0x4000000 + (int32_t)((log_q31 + 0x10) >> 5);
}

q16 q16_log2(q16 x)
{
    QTRI_MATH_CHECK(x > 0);
    return x <= 0 ? Q16_MIN : (log2_q26((uint32_t)x) + 0x200) >> 10;
}

q16 q16_log(q16 x)
{
    QTRI_MATH_CHECK(x > 0);
    if (x <= 0) {
        return Q16_MIN;
    }
    /* log2 is at least -16 and -16 ln 2 is taken away again. */
    uint32_t above_q26 = (uint32_t)(log2_q26((uint32_t)x) + 0x40000000);
    int32_t log_q25 = (int32_t)(qtri_mul_high31(above_q26, LN2_Q31) - (LN2_Q31 >> 2));
    return (log_q25 + 0x100) >> 9;
}

/* ---- Powers ---- */

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
    q16 size = exp2_product(y, precise_log2_q43(qtri_magnitude32(x)));
    if (!negative) {
        return size;
    }
    return size == Q16_MAX ? Q16_MIN : -size;
}
