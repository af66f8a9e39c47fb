/* SPDX-License-Identifier: MIT */
/*
 * Clipping in homogeneous coordinates: near, far, and a guard band in x and y.
 *
 * The sides of the picture are not clipped at all: pixels outside it are simply not visited. The
 * guard band only keeps snapped coordinates in range, and is as wide as 64-bit products of them
 * allow: 2^(29 - bits) pixels to each side, 2^21 for 8 sub-pixel bits, so that it almost never cuts
 * anything.
 */
#ifndef QTRI_HOST_REFERENCE_CLIP_H
#define QTRI_HOST_REFERENCE_CLIP_H

#include "../io/scene.h"
#include "matrix.h"
#include "primitive.h"

#define REF_CLIP_PLANES    6
#define REF_CLIP_MAX_COUNT (3 + REF_CLIP_PLANES) /* a plane adds at most one vertex */

struct ref_polygon {
    int count;
    struct ref_vertex vertex[REF_CLIP_MAX_COUNT];
};

/* Pixels to each side for vertices snapped to this many sub-pixel bits; 0 counts as 8. */
long double ref_guard_band(int subpixel_bits);

/* Clips a triangle for this part of a picture. All vertices of the result have w > 0; it has 0 or
   at least 3 vertices, in the order of the triangle's. */
void ref_clip_triangle(const struct ref_vertex vertex[3], const struct ref_window *window,
                       long double guard, struct ref_polygon *polygon);

/* The same for a line, in place; false if nothing is left. */
bool ref_clip_line(struct ref_vertex end[2], const struct ref_window *window, long double guard);

/* A vertex of a scene in clip space, in this colour. */
struct ref_vertex ref_vertex_of(const struct ref_matrix *to_clip, const struct scene_vertex *in,
                                const int32_t color[3]);

/* Whether every coordinate is a finite number. */
bool ref_vertex_is_finite(const struct ref_vertex *vertex);

/* Whether all three vertices lie outside the same side of the frustum, sides of the picture
   included, or have w <= 0: then nothing of the triangle can be seen. */
bool ref_clip_all_outside(const struct ref_vertex vertex[3]);

#endif
