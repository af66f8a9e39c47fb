/* SPDX-License-Identifier: MIT */
/*
 * What the linear part of a transform does to directions. Internal.
 */
#ifndef QTRI_GEOMETRY_LINEAR_PART_H
#define QTRI_GEOMETRY_LINEAR_PART_H

#include <stdbool.h>

#include "qtri/transform.h"

/* With one exponent, that of its largest row, which is returned; a fourth column is left alone. */
int32_t qtri_linear_align(int32_t out[3][4], const qtri_transform *t);

/* Of two columns; |m| <= 2^30, in one of them 2^31. */
int64_t qtri_linear_dot(int32_t m[3][4], int i, int j);

/*
 * Columns of equal length, at right angles, to 2^-20: far above the noise of a rotation in Q2.30,
 * far below 1/255.
 */
bool qtri_linear_is_even(int32_t m[3][4]);

/* The inverse transpose up to a positive factor: |element| < 2^28 or so; zeros where it has none.
 */
void qtri_linear_normals(int32_t out_q28[3][3], const qtri_transform *object_to_eye);

#endif
