/* SPDX-License-Identifier: MIT */
/*
 * The angle that atan2, asin and acos share. Internal.
 */
#ifndef QTRI_MATH_ATAN_H
#define QTRI_MATH_ATAN_H

#include <stdbool.h>
#include <stdint.h>

#include "qtri/q16.h"

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
