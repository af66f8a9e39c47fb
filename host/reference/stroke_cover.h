/* SPDX-License-Identifier: MIT */
/*
 * Exact coverage of strokes: which share of each pixel's area a union of discs and rectangles has.
 *
 * In double precision, by 512 lines a row: along each the union of intervals is exact. What lines
 * miss is a side that is nearly level: 1/1024 of a pixel for each such side.
 */
#ifndef QTRI_HOST_REFERENCE_STROKE_COVER_H
#define QTRI_HOST_REFERENCE_STROKE_COVER_H

#include <stdbool.h>
#include <stddef.h>

enum ref_cap { REF_CAP_ROUND, REF_CAP_BUTT, REF_CAP_SQUARE };

/* A straight part from (x0, y0) to (x1, y1) in pixels. */
struct ref_stroke_part {
    double x0, y0, x1, y1, radius;
    enum ref_cap cap[2];
};

/* The share 0..1 of each pixel of a row that the union of `count` parts covers. */
void ref_stroke_cover_row(const struct ref_stroke_part *part, size_t count, int row, int width,
                          double *share);

/* Whether the point lies inside the union. Left and upper sides count as inside. */
bool ref_stroke_contains(const struct ref_stroke_part *part, size_t count, double x, double y);

/* The part whose line is nearest to the point: its number, where along it that is, 0..1, and how
   far; 0 and INFINITY of none. */
size_t ref_stroke_nearest(const struct ref_stroke_part *part, size_t count, double x, double y,
                          double *along, double *distance);

#endif
