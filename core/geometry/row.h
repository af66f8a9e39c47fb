/* SPDX-License-Identifier: MIT */
/*
 * Rows of transforms, to and from wide scalars. Internal.
 */
#ifndef QTRI_GEOMETRY_ROW_H
#define QTRI_GEOMETRY_ROW_H

#include <stdbool.h>

#include "qtri/transform.h"

#include "../bits/wide.h"

/* The row x y z t, block-normalised: the only place where a transform is rounded. */
void qtri_row_from_wide(qtri_row *row, const qtri_wide element[4]);

/* The same with nothing but x in column i and y in column j. */
void qtri_row_from_two(qtri_row *row, int i, const qtri_wide *x, int j, const qtri_wide *y);

/*
 * The row with linear part `axis` that takes `point` to `image`, or to 0 for NULL: its translation
 * is computed from the rounded axis, or it would not cancel near `point`.
 */
void qtri_row_about(qtri_row *row, const qtri_wide axis[3], const qtri_wide point[3],
                    const qtri_wide *image);

/*
 * The sum of factor[k] 2^-exponent row[k] for count <= 3, plus the translation t 2^-(exponent +
 * 16), without wide scalars: |factor| <= 2^30, the rows as transform.h promises, |t| < 2^61. False,
 * and *out as it was, where 64 bits would lose some.
 */
bool qtri_row_combine(qtri_row *out, const qtri_row *const row[], const int32_t factor[], int count,
                      int32_t exponent, int64_t t);

/* The product of a row and the rows of a transform, whatever they are. */
void qtri_row_mul(qtri_row *out, const qtri_row *a, const qtri_transform *b);

/* Element 0..3 of a row. */
qtri_wide qtri_row_element(const qtri_row *row, int column);

#endif
