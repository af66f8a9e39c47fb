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

/*
 * Whether a triangle that is not culled counts as front: one that crosses a plane does, one that
 * lies beyond a plane does not.
 */
static inline bool qtri_front_is(qtri_cull cull, qtri_vertex *const vertex[3])
{
    if (!qtri_mesh_is_inside(vertex[0], vertex[1], vertex[2])) {
        return !qtri_mesh_is_outside(vertex);
    }
    return qtri_culls(cull) ||
           !qtri_triangle_is_back(&vertex[0]->at, &vertex[1]->at, &vertex[2]->at);
}

/* No triangle of `count` faces the eye, nor does the one behind them. */
static inline void qtri_front_clear(uint32_t *front, uint32_t count)
{
    for (uint32_t left = count / 32 + 1; left > 0; left--) {
        *front++ = 0;
    }
}

#endif
