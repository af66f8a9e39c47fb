/* SPDX-License-Identifier: MIT */
/*
 * Outlines from inside: what faces the eye, and who looks for edges in it. Internal.
 *
 * A drawing, or a prepared mesh, notes what faces the eye, a bit a triangle: outline_draw.c. From
 * that outline.c finds edges, for lists or to walk along them.
 */
#ifndef QTRI_DRAW_OUTLINE_H
#define QTRI_DRAW_OUTLINE_H

#include "qtri/edges.h"

#include "edge_walk.h"
#include "mesh_job.h"

static inline void qtri_front_set(uint32_t *front, uint32_t triangle)
{
    front[triangle >> 5] |= (uint32_t)1 << (triangle & 31);
}

/* At bit 0, others being above it. */
static inline uint32_t qtri_front_bit(const uint32_t *front, uint32_t triangle)
{
    return qtri_rotated(front[triangle >> 5], triangle);
}

static inline void qtri_front_unset(uint32_t *front, uint32_t triangle)
{
    front[triangle >> 5] &= ~((uint32_t)1 << (triangle & 31));
}

/* Whether a triangle that is not culled counts as front: one that crosses a plane does. */
static inline bool qtri_front_is(qtri_cull cull, const qtri_vertex *a, const qtri_vertex *b,
                                 const qtri_vertex *c)
{
    return cull != QTRI_CULL_NONE || !qtri_mesh_is_inside(a, b, c) ||
           !qtri_triangle_is_back(&a->at, &b->at, &c->at);
}

/* No triangle of `count` faces the eye, nor does the one behind them. */
static inline void qtri_front_clear(uint32_t *front, uint32_t count)
{
    for (uint32_t left = count / 32 + 1; left > 0; left--) {
        *front++ = 0;
    }
}

/* Nothing of it is seen. */
void qtri_outline_clear(qtri_outline *outline);

/* After facing is known: what the edges' search needs of a drawing in this memory of vertices. */
void qtri_outline_set(qtri_outline *outline, qtri_vertex *vertices, const qtri_view *view,
                      const qtri_transform *pose, const qtri_material *material, int32_t width,
                      int32_t height);

#endif
