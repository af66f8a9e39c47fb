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
