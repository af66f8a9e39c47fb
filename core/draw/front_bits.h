/* SPDX-License-Identifier: MIT */
/*
 * Which triangles of a mesh face the eye: a bit each. Internal.
 */
#ifndef QTRI_DRAW_FRONT_BITS_H
#define QTRI_DRAW_FRONT_BITS_H

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

#endif
