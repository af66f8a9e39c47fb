/* SPDX-License-Identifier: MIT */
/*
 * Small triangles: fragments that pass the depth test wait in the raster's batch until there are
 * enough of them to go through the stages of their pixels together, whichever triangles of the draw
 * call they belong to. Internal.
 *
 * Depth is written when a fragment is appended, so that those of a batch may lie on each other: the
 * last that is stored is the nearest. Where texels may be turned away, depth is written after that,
 * and tested once more then, in the order of drawing: another fragment of the batch may have been
 * stored there. What fails at first would fail then, too, for what is written passed the same
 * comparison; but for NOT_EQUAL, where the batch ends with each triangle.
 *
 * Fog and blends (effect.h) come when the batch is drawn, with the depth that each fragment has
 * kept. A blend reads what those before have stored.
 *
 * This is not a short cut: it says what the pixels of a small triangle are. Loops of core/fast
 * draw the same.
 */
#ifndef QTRI_RASTER_LIST_H
#define QTRI_RASTER_LIST_H

#include "place.h"
#include "raster.h"
#include "triangle.h"

/*
 * Texture coordinates along one axis at the three vertices: `repeats` and at[i] 2^-fraction
 * repeats more. |at| <= 2^30, fraction 12..30.
 */
typedef struct qtri_coordinates {
    int32_t at[3];
    int32_t repeats;
    int32_t fraction;
} qtri_coordinates;

/* From those of qtri_screen_vertex; beyond 2^48 they are held there. */
void qtri_coordinates_set(qtri_coordinates *out, const int64_t at_q32[3]);

typedef struct qtri_list_triangle {
    qtri_place *place; /* its base becomes pixel (0, 0) */
    const qtri_vertex *v[3];
    const int32_t (*color)[3];  /* channels of each vertex; NULL: shares of the tint, by light */
    uint32_t light_q15;         /* of all; QTRI_VERTEX_UNLIT: the vertices' own */
    const qtri_coordinates *uv; /* u and v; read where the raster has a texture */
} qtri_list_triangle;

void qtri_list_draw(const qtri_raster *raster, const qtri_list_triangle *t);

/* Draws those that wait: at the end of a draw call, and before anything else is drawn. */
void qtri_list_flush(const qtri_raster *raster);

#endif
