/* SPDX-License-Identifier: MIT */
/* Areas of triangles on the screen, and which of them are culled. Internal. */
#ifndef QTRI_RASTER_TRIANGLE_H
#define QTRI_RASTER_TRIANGLE_H

#include "qtri/draw.h"
#include "qtri/view.h"

#include "../bits/bits.h"

#if !QTRI_LONG_MULTIPLY
/* Whether differences fit 15 bits with their sign: their products then fit 30, one instruction. */
static inline bool qtri_differences_are_short(int32_t a, int32_t b, int32_t c, int32_t d)
{
    uint32_t half = (uint32_t)1 << 14;
    QTRI_HOLD(half); /* GCC 12 would make it anew for each */
    return (((uint32_t)a + half) | ((uint32_t)b + half) | ((uint32_t)c + half) |
            ((uint32_t)d + half)) < 2 * half;
}

/* qtri_triangle_area where products need 64 bits, which is rare: out of line. */
int64_t qtri_triangle_area_long(const qtri_point *a, const qtri_point *b, const qtri_point *c);
#endif

/* Twice the area in 1/256 pixel squared; y points down: negative is front. |x|, |y| <= 2^22.
   Inlined, but where code is to be small. */
int64_t qtri_triangle_area(const qtri_point *a, const qtri_point *b, const qtri_point *c);
static inline int64_t qtri_triangle_area_in_place(const qtri_point *a, const qtri_point *b,
                                                  const qtri_point *c)
{
    int32_t dx1 = b->x_24p8 - a->x_24p8, dy1 = b->y_24p8 - a->y_24p8;
    int32_t dx2 = c->x_24p8 - a->x_24p8, dy2 = c->y_24p8 - a->y_24p8;
#if !QTRI_LONG_MULTIPLY
    if (qtri_differences_are_short(dx1, dy1, dx2, dy2)) {
        return dx1 * dy2 - dx2 * dy1;
    }
    return qtri_triangle_area_long(a, b, c);
#else
    return qtri_mul_s32(dx1, dy2) - qtri_mul_s32(dx2, dy1);
#endif
}
#if !QTRI_SHARE
#define qtri_triangle_area qtri_triangle_area_in_place
#endif

/* qtri_triangle_area(a, b, c) >= 0, most of a mesh's triangles: without 64 bits where it can be. */
static inline bool qtri_triangle_is_back(const qtri_point *a, const qtri_point *b,
                                         const qtri_point *c)
{
#if !QTRI_LONG_MULTIPLY
    const uint32_t half = (uint32_t)1 << 14;
    int32_t dx1 = b->x_24p8 - a->x_24p8;
    uint32_t far = (uint32_t)dx1 + half;
    QTRI_HOLD(far);
    int32_t dx2 = c->x_24p8 - a->x_24p8;
    far |= (uint32_t)dx2 + half;
    QTRI_HOLD(far);
    int32_t dy1 = b->y_24p8 - a->y_24p8;
    far |= (uint32_t)dy1 + half;
    QTRI_HOLD(far);
    int32_t dy2 = c->y_24p8 - a->y_24p8;
    far |= (uint32_t)dy2 + half;
    if (far < 2 * half) {
        return dx1 * dy2 >= dx2 * dy1;
    }
    return qtri_triangle_area_long(a, b, c) >= 0;
#else
    return qtri_triangle_area(a, b, c) >= 0;
#endif
}

/* Whether triangles of one side are culled; a number that is no qtri_cull culls none. */
static inline bool qtri_culls(qtri_cull cull)
{
    return cull == QTRI_CULL_BACK || cull == QTRI_CULL_FRONT;
}

/* Whether a triangle of this signed area is culled; one without area is, from either side. */
static inline bool qtri_is_culled(qtri_cull cull, int64_t area)
{
    return (cull == QTRI_CULL_BACK && area >= 0) || (cull == QTRI_CULL_FRONT && area <= 0);
}

#endif
