/* SPDX-License-Identifier: MIT */
/*
 * What the conversions between fixed-point formats share. Internal.
 */
#ifndef QTRI_MATH_SCALED_H
#define QTRI_MATH_SCALED_H

#include <stdint.h>

/* value 2^shift, correctly rounded, halves up, saturated. */
int32_t qtri_scaled(int32_t value, int shift);

#endif
