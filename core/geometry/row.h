/* SPDX-License-Identifier: MIT */
/*
 * Rows of transforms: to and from wide scalars, their products, what their linear parts do to
 * directions, and rows for integers of 16 bits. Internal.
 */
#ifndef QTRI_GEOMETRY_ROW_H
#define QTRI_GEOMETRY_ROW_H

#include "qtri/transform.h"

#include <stdbool.h>

#include "../bits/bits.h"
#include "../bits/wide.h"

void qtri_wide_from_vec3(qtri_wide out[3], const qtri_vec3 *v);

/* The row x y z t, block-normalised: the only place where a transform is rounded. */
void qtri_row_from_wide(qtri_row *row, const qtri_wide element[4]);

/* A row of zeros but for x in column i and y in column j, block-normalised. */
void qtri_row_from_two(qtri_row *row, int i, const qtri_wide *x, int j, const qtri_wide *y);

/*
 * The row with linear part `axis` that takes `point` to `image`, or to 0 for NULL: its translation
 * is computed from the rounded axis, or it would not cancel near `point`.
 */
void qtri_row_about(qtri_row *row, const qtri_wide axis[3], const qtri_wide point[3],
                    const qtri_wide *image);

/*
 * The sum of factor[k] 2^-exponent row[k] for count <= 3, plus the translation t 2^-(exponent +
 * 16), without wide scalars, for any m and translations below 2^61. False, and *out as it was,
 * where 64 bits would lose some.
 */
bool qtri_row_combine(qtri_row *out, const qtri_row *const row[], const int32_t factor[], int count,
                      int32_t exponent, int64_t t);

/* The product of a row and the rows of a transform, whatever they are. */
void qtri_row_mul(qtri_row *out, const qtri_row *a, const qtri_transform *b);

/* A row's linear part, x y z. */
void qtri_row_axis(qtri_wide out[3], const qtri_row *row);

/* Element 0..3 of a row. */
qtri_wide qtri_row_element(const qtri_row *row, int column);

/* ---- Linear parts ---- */

/* The linear part with one exponent, that of its largest row, which is returned; out[][3] stays. */
int32_t qtri_linear_align(int32_t out[3][4], const qtri_transform *t);

/* The dot product of columns i and j; |m| <= 2^30, in one of them 2^31. */
int64_t qtri_linear_dot(int32_t m[3][4], int i, int j);

/*
 * Whether columns have one length and are at right angles, to 2^-20: far above the noise of a
 * rotation in Q2.30, far below 1/255.
 */
bool qtri_linear_is_even(int32_t m[3][4]);

/* The inverse transpose up to a positive factor: |element| < 2^28 or so; zeros where it has none.
 */
void qtri_linear_normals(int32_t out_q28[3][3], const qtri_transform *object_to_eye);

/* ---- Rows for 16 bits ---- */

/*
 * A row for 16-bit positions or normals n: floor((m . n + t) / 2^16), |m| <= 2^31, all multiples of
 * 4. Without a long multiply m and t are stored as high 2^16 + 4 low, so that every product fits 32
 * bits: two short products a coefficient, instead of one that is put together from four.
 */
typedef struct qtri_row16 {
#if QTRI_LONG_MULTIPLY
    int64_t t_q16; /* times 2^16 */
    int32_t m[3];
#else
    int32_t t_high, t_low;
    int32_t high[3], low[3];
#endif
} qtri_row16;

void qtri_row16_set(qtri_row16 *row, const int32_t m[3], int64_t t);

/* m, as it was set. */
static inline int32_t qtri_row16_coefficient(const qtri_row16 *row, int i)
{
#if QTRI_LONG_MULTIPLY
    return row->m[i];
#else
    return row->high[i] * 65536 + row->low[i] * 4;
#endif
}

/* floor(t / 2^15). */
static inline int32_t qtri_row16_translation(const qtri_row16 *row)
{
#if QTRI_LONG_MULTIPLY
    return (int32_t)(row->t_q16 >> 31);
#else
    return row->t_high * 2 + (row->t_low >> 13);
#endif
}

/* floor((m . n + t) / 2^16) for |n| <= 2^15. */
#if QTRI_LONG_MULTIPLY
/* No longer than its call. */
QTRI_INLINE int32_t qtri_row16_sum(const qtri_row16 *row, int32_t x, int32_t y, int32_t z)
{
    int64_t sum = row->t_q16;
    sum += (int64_t)row->m[0] * (x * 65536);
    sum += (int64_t)row->m[1] * (y * 65536);
    sum += (int64_t)row->m[2] * (z * 65536);
    int32_t high = (int32_t)(sum >> 32);
    QTRI_HOLD(high); /* or GCC 12 takes it for one of 64 bits wherever it is multiplied */
    return high;
}
#else
static inline int32_t qtri_row16_sum(const qtri_row16 *row, int32_t x, int32_t y, int32_t z)
{
    /* |m| sums up to 2^31: the high parts to 2^30. The low ones are 3 2^14 2^15 + 2^14 < 2^31. */
    int32_t low = row->t_low + row->low[0] * x + row->low[1] * y + row->low[2] * z;
    return row->t_high + row->high[0] * x + row->high[1] * y + row->high[2] * z + (low >> 14);
}
#endif

#endif
