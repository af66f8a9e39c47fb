/* SPDX-License-Identifier: MIT */
#include "qtri/q16_exp.h"

#include "../bits/bits.h"
#include "coefficients.h"
#include "../bits/multiply.h"

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
