/* SPDX-License-Identifier: MIT */
/*
 * Sine and cosine with the precision that rotations need, and the angle that atan2, asin and acos
 * share. Internal.
 */
#ifndef QTRI_MATH_Q16_TRIG_H
#define QTRI_MATH_Q16_TRIG_H

#include <stdbool.h>
#include <stdint.h>

#include "qtri/q16.h"

#define QTRI_RADIANS_PER_DEGREE_Q37 2398762259u /* pi / 180 * 2^37, rounded */

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

/* Polynomials: w in Q31 is the distance from a right angle in eighths of a turn, up to 1. */
uint32_t qtri_sine_of_eighths_q30(uint32_t w);
uint32_t qtri_cosine_of_eighths_q30(uint32_t w);

/*
 * The angle of the direction (x, y) of the first quadrant, mirrored into the second with
 * `mirrored`: Q31 of half a turn, 0..2^31, within 2^-29. 0 for (0, 0).
 */
uint32_t qtri_angle_q31(uint32_t y, uint32_t x, bool mirrored);

/* Between the sides |x| and sqrt(1 - x^2), |x| taken as 1 at most: opposite x, or at it. */
uint32_t qtri_side_angle_q31(q16 x, bool cosine);

static inline q16 qtri_half_turns_to_degrees(uint32_t angle_q31)
{
    /* 180 2^16 / 2^31 = 45 / 2^13 */
    return (q16)((angle_q31 >> 13) * 45u + (((angle_q31 & 0x1FFFu) * 45u + 0x1000u) >> 13));
}

q16 qtri_half_turns_to_radians(uint32_t angle_q31);

#endif
