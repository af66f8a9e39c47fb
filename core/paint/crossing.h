/* SPDX-License-Identifier: MIT */
/*
 * The edges of a contour that cross a row. Internal.
 */
#ifndef QTRI_PAINT_CROSSING_H
#define QTRI_PAINT_CROSSING_H

#include "ink.h"

typedef struct qtri_crossing {
    int32_t x0, x1; /* 24.8 at y0 and y1 */
    int32_t y0, y1; /* in 1/256 below the row's upper side, 0 <= y0 < y1 <= 256 */
    int32_t winding;
    const qtri_ink_edge *arc; /* NULL: straight */
} qtri_crossing;

/* Those that are looked at more than once a row are kept, so that most edges are cut only once. */
enum { QTRI_CROSSINGS_KEPT = 12 };

typedef struct qtri_crossings {
    const qtri_contour *contour;
    int32_t row_24p8;     /* the row's upper side */
    int32_t first;        /* the column where the first of them begins; or further left */
    int32_t kept, others; /* how many are kept, and the first edge behind them */
    qtri_crossing crossing[QTRI_CROSSINGS_KEPT];
} qtri_crossings;

void qtri_crossings_init(qtri_crossings *crossings, const qtri_contour *contour, int32_t row);

/* Side i of a polygon where it may cross the row whose upper side is `top`; false: it does not. */
bool qtri_contour_side_near(const qtri_contour *contour, int32_t i, int32_t top_24p8,
                            qtri_ink_edge *side);

/* The next one, and NULL after the last: *position begins with 0. `room` is for one not kept. */
const qtri_crossing *qtri_crossings_next(const qtri_crossings *crossings, int32_t *position,
                                         qtri_crossing *room);

#endif
