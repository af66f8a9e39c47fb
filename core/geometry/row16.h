/* SPDX-License-Identifier: MIT */
/*
 * Rows that are applied to vectors of 16-bit integers: positions and normals. Internal.
 *
 * On a core without a long multiply they cost two short products a coefficient instead of one that
 * is put together from four.
 */
#ifndef QTRI_GEOMETRY_ROW16_H
#define QTRI_GEOMETRY_ROW16_H

#include "../bits/bits.h"

/*
 * A row for 16-bit positions n: floor((m . n + t) / 2^16), |m| <= 2^31, all multiples of 4. Without
 * a long multiply m and t are stored as high 2^16 + 4 low, so that every product fits 32 bits.
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
static inline int32_t qtri_row16_sum(const qtri_row16 *row, int32_t x, int32_t y, int32_t z)
{
#if QTRI_LONG_MULTIPLY
    int64_t sum = row->t_q16;
    sum += (int64_t)row->m[0] * (x * 65536);
    sum += (int64_t)row->m[1] * (y * 65536);
    sum += (int64_t)row->m[2] * (z * 65536);
    int32_t high = (int32_t)(sum >> 32);
    QTRI_HOLD(high); /* or GCC 12 takes it for one of 64 bits wherever it is multiplied */
    return high;
#else
    /* |m| sums up to 2^31: the high parts to 2^30. The low ones are 3 2^14 2^15 + 2^14 < 2^31. */
    int32_t low = row->t_low + row->low[0] * x + row->low[1] * y + row->low[2] * z;
    return row->t_high + row->high[0] * x + row->high[1] * y + row->high[2] * z + (low >> 14);
#endif
}

#endif
