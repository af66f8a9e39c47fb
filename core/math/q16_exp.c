/* SPDX-License-Identifier: MIT */
#include "qtri/q16_exp.h"

#include "../bits/bits.h"
#include "coefficients.h"
#include "exp2.h"
#include "../bits/multiply.h"

#define LOG2_E_Q40 1586259972792
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
 * 2^(v + w) = 2^v (1 + w ln 2 + ...) for w < 2^-16: the next term is below 2^-34. With the largest
 * w what is added grows with v; to 0xFFFE9D1C, of the largest v, it is 0x162E3: the sum is 2^32 - 1
 * at most, and less of any other v (all were tried).
 */
q16 qtri_exp2_product(q16 factor, int64_t log_q40)
{
    int64_t x_q40 = qtri_mul_s32(factor, (int32_t)(log_q40 >> 16)) +
                    (qtri_mul_s32(factor, (int32_t)(log_q40 & 0xFFFF)) >> 16); /* < 2^60 */
    int64_t exponent = x_q40 >> 40;
    if (exponent >= 15) {
        QTRI_MATH_CHECK(false);
        return Q16_MAX;
    }
    if (exponent < -17) {
        return 0;
    }
    uint32_t v_q16 = (uint32_t)(x_q40 >> 24) & 0xFFFFu;
    uint32_t w_q40 = (uint32_t)x_q40 & 0xFFFFFFu;
    uint32_t p_q32 = power_q32(v_q16);
    uint32_t w_q32 = (qtri_mul_high16(w_q40 << 8, LN2_Q16) + 0x8000u) >> 16;
    uint32_t more_q32 = w_q32 + ((qtri_mul_high16(p_q32, w_q32) + 0x8000u) >> 16);
    return scaled(p_q32 + more_q32, (int32_t)exponent);
}

q16 q16_exp(q16 x)
{
    return qtri_exp2_product(x, LOG2_E_Q40);
}
