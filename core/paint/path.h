/* SPDX-License-Identifier: MIT */
/*
 * Outlines put together from straight lines and arcs. Internal.
 */
#ifndef QTRI_PAINT_PATH_H
#define QTRI_PAINT_PATH_H

#include "ink.h"

/* An arc of a ring: five quarters or parts of them outside, five inside, two ends. */
enum { QTRI_PATH_EDGES = 12 };

typedef struct qtri_path {
    int32_t count;
    int32_t direction; /* +1, or -1: edges are added against their direction */
    qtri_ink_edge edge[QTRI_PATH_EDGES];
} qtri_path;

static inline void qtri_path_init(qtri_path *path)
{
    path->count = 0;
    path->direction = 1;
}

/* From one point to another. */
void qtri_path_line(qtri_path *path, const qtri_point *from, const qtri_point *to);

/*
 * A quarter of a circle, clockwise in the picture: 0 from the right down, 1 from there to the left,
 * 2 up, 3 to the right. Of it, what lies between the rows y0 and y1, y0 <= y1, both inside it.
 */
void qtri_path_quarter(qtri_path *path, const qtri_point *center, int32_t radius_24p8,
                       int32_t quarter, int32_t y0_24p8, int32_t y1_24p8);

/* All of a circle; a radius of 0 adds nothing. */
void qtri_path_circle(qtri_path *path, const qtri_point *center, int32_t radius_24p8);

void qtri_path_paint(const qtri_path *path, const qtri_surface *surface, const qtri_brush *brush);

#endif
