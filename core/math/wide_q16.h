/*
 * From wide scalars to Q16.16. Internal.
 */
#ifndef QTRI_MATH_WIDE_Q16_H
#define QTRI_MATH_WIDE_Q16_H

#include "wide.h"

/* Nearest, halves up, saturated. */
int32_t qtri_wide_to_q16(qtri_wide a);

/* The sum of a[i] b[i], of the real numbers; as exact as it needs to be for all count <= 4. */
qtri_wide qtri_wide_dot(const int32_t *a, const int32_t *b, int32_t count);

#endif
