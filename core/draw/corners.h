/* SPDX-License-Identifier: MIT */
/*
 * Triangles whose corners are no mesh's vertices: what draws them, lit and unlit. Internal.
 */
#ifndef QTRI_DRAW_CORNERS_H
#define QTRI_DRAW_CORNERS_H

#include "primitive.h"

/* What becomes of a triangle's corners. */
typedef enum qtri_corners_fate {
    QTRI_CORNERS_ELSEWHERE, /* not decided: one is outside, or not at w = 1 */
    QTRI_CORNERS_CULLED,
    QTRI_CORNERS_SEEN /* all of it */
} qtri_corners_fate;

/*
 * Vertices of a triangle and of the one before, with which it shares a third of its corners or more
 * where triangles are in the order that files have them in. `before` is NULL where none was placed.
 */
typedef struct qtri_corner_vertices {
    qtri_vertex vertex[2][3];
    const qtri_vertex *before;
} qtri_corner_vertices;

/* A solid triangle whose corners are like vertices of a mesh, as most are: in their way. */
qtri_corners_fate qtri_corners_place(const qtri_primitive *primitive, qtri_corner_vertices *kept,
                                     const qtri_corner *corners, qtri_fan_vertex fan[3]);

/* Draws it, at the corners' positions and with the colours and coordinates of `attributes`. */
void qtri_corners_draw(const qtri_primitive *primitive, qtri_fan_vertex fan[3],
                       const qtri_corner *corners, const qtri_corner *attributes);

/* Transforms `count` corners of one primitive, which then share one scale. */
void qtri_corners_fetch(const qtri_primitive *primitive, const qtri_corner *corners, int count,
                        qtri_clip_vertex v[3]);

/* A qtri_attribute_source, from three corners. */
void qtri_corners_attributes(const void *from, qtri_screen_vertex attributes[3]);

#endif
