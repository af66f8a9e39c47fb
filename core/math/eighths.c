/* SPDX-License-Identifier: MIT */
#include "eighths.h"

#include "coefficients.h"
#include "../bits/multiply.h"

/* Both results exceed the polynomial's error by .002 ULP: most of it the last place of 16-bit
 * coefficients. */
uint32_t qtri_sine_of_eighths_q30(uint32_t w)
{
    uint32_t v_q30 = qtri_mul_high31(w, w);
    uint32_t v_q16 = v_q30 >> 14;
    uint32_t sum = QTRI_SINE_2_Q24 - ((QTRI_SINE_3_Q30 * v_q16) >> 22); /* < 2^16 */
    sum = QTRI_SINE_1_Q33 - ((sum * v_q16) >> 7);
    sum = QTRI_SINE_0_Q31 - qtri_mul_high31(v_q30, sum);
    return qtri_mul_high31(w, sum);
}

uint32_t qtri_cosine_of_eighths_q30(uint32_t w)
{
    uint32_t v_q30 = qtri_mul_high31(w, w);
    uint32_t v_q16 = v_q30 >> 14;
    uint32_t sum = QTRI_COSINE_2_Q36 - ((QTRI_COSINE_3_Q27 * v_q16) >> 7);
    sum = QTRI_COSINE_1_Q32 - (qtri_mul_high31(v_q30, sum) >> 2);
    return QTRI_COSINE_0_Q30 - qtri_mul_high31(v_q30, sum);
}
