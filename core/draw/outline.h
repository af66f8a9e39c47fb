/*
 * Outlines from inside: what faces the eye, and who looks for edges in it. Internal.
 *
 * A drawing, or a prepared mesh, notes what faces the eye, a bit a triangle: outline_draw.c. From
 * that outline.c finds edges, for lists or to walk along them.
 */
#ifndef QTRI_DRAW_OUTLINE_H
#define QTRI_DRAW_OUTLINE_H

#include "qtri/edges.h"

#include "mesh_job.h"

static inline void qtri_front_set(uint8_t *front, uint32_t triangle)
{
    front[triangle >> 3] |= (uint8_t)(1u << (triangle & 7));
}

static inline uint32_t qtri_front_bit(const uint8_t *front, uint32_t triangle)
{
    return front[triangle >> 3] >> (triangle & 7);
}

/* Whether a triangle that is not culled counts as front: one that crosses a plane does. */
static inline bool qtri_front_is(qtri_cull cull, const qtri_vertex *a, const qtri_vertex *b,
                                 const qtri_vertex *c)
{
    return cull != QTRI_CULL_NONE || !qtri_mesh_is_inside(a, b, c) ||
           !qtri_triangle_is_back(&a->at, &b->at, &c->at);
}

/* No triangle of `count` faces the eye, nor does the one behind them. */
static inline void qtri_front_clear(uint8_t *front, uint32_t count)
{
    uint32_t *word = (uint32_t *)(void *)front;
    for (uint32_t left = count / 32 + 1; left > 0; left--) {
        *word++ = 0;
    }
}

/* Nothing of it is seen. */
void qtri_outline_clear(qtri_outline *outline);

/* After facing is known: what the edges' search needs of a drawing in this memory of vertices. */
void qtri_outline_set(qtri_outline *outline, qtri_vertex *vertices, const qtri_view *view,
                      const qtri_transform *pose, const qtri_material *material, int32_t width,
                      int32_t height);

#endif
