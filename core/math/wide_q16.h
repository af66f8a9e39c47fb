/* SPDX-License-Identifier: MIT */
/*
 * From wide scalars to Q16.16. Internal.
 */
#ifndef QTRI_MATH_WIDE_Q16_H
#define QTRI_MATH_WIDE_Q16_H

#include "../bits/wide.h"

/* Nearest, halves up, saturated. */
int32_t qtri_wide_to_q16(qtri_wide a);

/* m 2^-16 - a b, rounded like that. */
int32_t qtri_wide_less(int64_t m, const qtri_wide *a, const qtri_wide *b);

/* The sum of a[i] b[i], of the real numbers; as exact as it needs to be for all count <= 4. */
void qtri_wide_dot(qtri_wide *sum, const int32_t *a, const int32_t *b, int32_t count);

/* x = numerator / x. */
void qtri_wide_invert(qtri_wide *x, int32_t numerator);

#endif
