/* SPDX-License-Identifier: MIT */
/*
 * Which pixels of a row belong to a triangle. Internal.
 *
 * Edges are walked apart from the pixels, a few rows ahead: what fills rows need not know how a
 * span was found, and both keep their numbers in registers.
 */
#ifndef QTRI_RASTER_ROWS_H
#define QTRI_RASTER_ROWS_H

#include "dda.h"
#include "triangle.h"

/*
 * First row whose centre is at or below y, or column whose centre is at or right of x:
 * ceil((y - 128) / 256). The end is excluded likewise.
 */
static inline int32_t qtri_first_center(int32_t y_24p8)
{
    return (y_24p8 + 127) >> 8;
}

/*
 * An edge in few rows: its pixel in a row is `base` and numerator / denominator, rounded down. The
 * numerator is not negative in rows that the edge passes, and all fits 31 bits.
 */
typedef struct qtri_edge {
    int32_t numerator, step, denominator;
#if !QTRI_DIVIDE
    int32_t quotient; /* of the row before; at first, base */
#endif
} qtri_edge;

/* The pixel in this row; goes on to the next. */
static inline int32_t qtri_edge_next(qtri_edge *e, int32_t base)
{
#if QTRI_DIVIDE
    int32_t quotient = (int32_t)((uint32_t)e->numerator / (uint32_t)e->denominator);
    e->numerator += e->step;
    return base + quotient;
#else
    /* A pixel or two a row: cheaper than a division, and at most 73 at first. */
    int32_t numerator = e->numerator;
    int32_t quotient = e->quotient;
    (void)base;
    while (numerator < 0) {
        numerator += e->denominator;
        quotient--;
    }
    while (numerator >= e->denominator) {
        numerator -= e->denominator;
        quotient++;
    }
    e->numerator = numerator + e->step;
    e->quotient = quotient;
    return quotient;
#endif
}

/* Edges of a triangle that qtri_triangle_begin did not find short. */
typedef struct qtri_rows {
    qtri_dda left, right;
    qtri_dda lower; /* the second short edge: takes its side over at row `turn` */
    bool lower_is_left;
    int32_t row, turn, end; /* row: the next one */
} qtri_rows;

void qtri_rows_init(qtri_rows *rows, const qtri_triangle *triangle);

/* The next rows' spans, up to QTRI_ROWS_AHEAD; returns how many: 0 at the end. */
int32_t qtri_rows_next(qtri_rows *rows, qtri_span spans[QTRI_ROWS_AHEAD]);

#endif
