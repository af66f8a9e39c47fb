/* SPDX-License-Identifier: MIT */
/*
 * Sine and cosine with the precision that rotations need. Internal.
 */
#ifndef QTRI_MATH_SINCOS_H
#define QTRI_MATH_SINCOS_H

#include <stdbool.h>
#include <stdint.h>

/* Q2.30 sine and cosine of Q16.16 degrees, within 2^-29.5; multiples of 90 are exact. */
void qtri_sincos_deg_q30(int32_t degrees, int32_t *sine_q30, int32_t *cosine_q30);

/* a b in Q31, rounded, for factors up to 1. */
uint32_t qtri_mul_q31(uint32_t a, uint32_t b);

/* (1 - sin(x) / x) / x^2 or (1 - cos(x)) / x^2 in Q31 from x^2 in Q31, |x| <= pi/4. */
uint32_t qtri_series_q31(bool cosine, uint32_t square_q31);

/* sin(x) / x and cos(x), within 2^-30. */
static inline uint32_t qtri_sine_ratio_q31(uint32_t square_q31)
{
    return 0x80000000u - qtri_mul_q31(square_q31, qtri_series_q31(false, square_q31));
}

static inline uint32_t qtri_cosine_q31(uint32_t square_q31)
{
    return 0x80000000u - qtri_mul_q31(square_q31, qtri_series_q31(true, square_q31));
}

#endif
