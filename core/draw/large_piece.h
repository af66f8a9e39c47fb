/* SPDX-License-Identifier: MIT */
/*
 * Large triangles of draw calls, and pieces of what is clipped. Internal.
 */
#ifndef QTRI_DRAW_LARGE_PIECE_H
#define QTRI_DRAW_LARGE_PIECE_H

#include "../raster/large.h"
#include "primitive.h"

struct qtri_mesh_job;

/* Colour, u and v of a point from those of three vertices. */
void qtri_blend_attributes(qtri_screen_vertex *out, const qtri_screen_vertex *a0,
                           const qtri_screen_vertex *a1, const qtri_screen_vertex *a2,
                           int32_t b1_q30, int32_t b2_q30);

/* Flat: lines and the pieces of a clipped triangle have no provoking vertex of their own. */
void qtri_spread_provoking(const qtri_material *material, qtri_screen_vertex v[3]);

/* Which of the triangle's own vertices this is, that no plane made; otherwise -1. */
int qtri_own_vertex(const qtri_fan_vertex *v);

/* Whether it matters where vertices truly are, which are snapped to 1/256 pixel. */
bool qtri_rests_matter(const qtri_draw_state *state, const qtri_screen_point *const p[3],
                       const uint32_t depth_16p16[3], int64_t area);

/* Whether the triangle lies wholly on one side of what may be drawn. */
bool qtri_is_beside(const qtri_draw_state *state, const qtri_screen_point *const p[3]);

/* Where a mesh's vertices with these numbers truly are, if that matters: v[i].rest. */
void qtri_mesh_find_rests(qtri_large_vertex v[3], const struct qtri_mesh_job *draw,
                          const uint32_t index[3], const qtri_screen_point *const p[3],
                          int64_t area);

/* 0..255.0 each, rounded: 0x00RRGGBB. */
uint32_t qtri_color_word(const int32_t color_8p16[3]);

/*
 * Draws a triangle of what clipping left. With QTRI_LIGHT the light of a vertex is its
 * color_8p16[0], 255.0 being 1.
 */
void qtri_draw_large_piece(const qtri_primitive *primitive, const qtri_fan_vertex *const vertex[3],
                           int64_t area, qtri_attribute_source source, const void *from);

#endif
