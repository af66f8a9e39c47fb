/* SPDX-License-Identifier: MIT */
/*
 * Exact coverage of the pixels of a row by straight edges. Internal.
 *
 * The area of a pixel to the right of an edge, summed with the edges' directions, is what their
 * outline covers of it, in 1/512 by 1/256 pixel. A window of pixels has a sum each: what an edge
 * adds within one pixel, and the rest of what it adds to the next one, so that the sum of all sums
 * up to a pixel is its coverage. Wherever a window begins, a pixel's coverage is the same: an edge
 * is cut at the sides of columns, each cut being a function of the edge and the column alone, and
 * what lies left of the window is the difference of two of them.
 */
#ifndef QTRI_PAINT_COVERAGE_H
#define QTRI_PAINT_COVERAGE_H

#include "../bits/bits.h"

enum { QTRI_COVERAGE_WINDOW = 32 };

#define QTRI_COVERAGE_FULL ((int32_t)512 * 256)

typedef struct qtri_coverage {
    int32_t x, end; /* columns: x <= column < end <= x + QTRI_COVERAGE_WINDOW */
    int32_t sum[QTRI_COVERAGE_WINDOW + 1]; /* up to a pixel they add up to its coverage */
} qtri_coverage;

/* qtri_coverage_add() for an edge through several columns, or none of the window. */
void qtri_coverage_add_wide(qtri_coverage *w, int32_t x0, int32_t y0, int32_t x1, int32_t y1,
                            int32_t winding);

/* Adds a piece of an edge within one pixel: its signed height, and the sum of both ends' x from the
   pixel's left side, all in 1/256. */
QTRI_INLINE void qtri_coverage_add_piece(int32_t *sum, int32_t height, int32_t ends)
{
    const int32_t behind = height * ends;
    sum[0] += height * 512 - behind;
    sum[1] += behind;
}

/*
 * Adds the edge from (x0, y0) to (x1, y1), y in 1/256 below the row's upper side, 0 <= y <= 256,
 * |x| < 2^23. winding: 1 or -1 times what it counts downwards. Most edges stay in a column.
 */
static inline void qtri_coverage_add(qtri_coverage *c, int32_t x0, int32_t y0, int32_t x1,
                                     int32_t y1, int32_t winding)
{
    const int32_t column = x0 >> 8;
    if (x1 >> 8 == column && column >= c->x && column < c->end) {
        qtri_coverage_add_piece(&c->sum[column - c->x], winding * (y1 - y0),
                                x0 + x1 - 512 * column);
    } else {
        qtri_coverage_add_wide(c, x0, y0, x1, y1, winding);
    }
}

#endif
