/*
 * Sine and cosine with the precision that rotations need. Internal.
 */
#ifndef QTRI_MATH_SINCOS_H
#define QTRI_MATH_SINCOS_H

#include <stdint.h>

/* Q2.30 sine and cosine of Q16.16 degrees, within 2^-29.5; multiples of 90 are exact. */
void qtri_sincos_deg_q30(int32_t degrees, int32_t *sine_q30, int32_t *cosine_q30);

/* sin(x) / x and cos(x) in Q31 from x^2 in Q31, |x| <= pi/4, within 2^-30. */
uint32_t qtri_sine_ratio_q31(uint32_t square_q31);
uint32_t qtri_cosine_q31(uint32_t square_q31);

#endif
