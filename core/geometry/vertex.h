/* SPDX-License-Identifier: MIT */
/*
 * What the exact way and the fast way of a vertex to the screen share. Internal.
 */
#ifndef QTRI_GEOMETRY_VERTEX_H
#define QTRI_GEOMETRY_VERTEX_H

#include "projector.h"

#include "../bits/reciprocal.h"

/* floor(a b / 2^32). */
static inline int32_t qtri_mul_high_s32(int32_t a, int32_t b)
{
    return (int32_t)(qtri_mul_s32(a, b) >> 32);
}

/*
 * Window depth in steps of 2^-8 from z in the scale of w_q32, |z_q31| <= w_q32 / 2: times the
 * reciprocal, z / w in Q29.
 */
static inline uint32_t qtri_vertex_depth(const qtri_projector *projector, int32_t z_q31,
                                         int32_t reciprocal)
{
    int32_t ratio_q29 = qtri_mul_high_s32(z_q31, reciprocal); /* +-2^29 */
    int32_t half = qtri_mul_high_s32(projector->depth_reach, ratio_q29 * 4);
    return (projector->depth_center + (uint32_t)half * 2u) & ~0xFFu;
}

/* Plainly within the guard band: |x|, |y| <= 2^21. */
static inline bool qtri_vertex_in_guard(int32_t x_24p8, int32_t y_24p8)
{
    const uint32_t reach = QTRI_SCREEN_MAX_24P8 / 2;
    return (((uint32_t)x_24p8 + reach) | ((uint32_t)y_24p8 + reach)) < 2 * reach;
}

/* Outcode and projection of exact coordinates, as a vertex. */
void qtri_vertex_exact(const qtri_projector *projector, const qtri_clip_vertex *clip,
                       qtri_vertex *out);

#endif
