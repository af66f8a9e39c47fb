/*
 * What the exact way and the fast way of a vertex to the screen share. Internal.
 */
#ifndef QTRI_GEOMETRY_VERTEX_H
#define QTRI_GEOMETRY_VERTEX_H

#include "projector.h"

#include "../math/dot.h"

/*
 * The largest r with r x < 2^62, for x in [2^31, 2^32): in [2^30, 2^31). It is the reciprocal
 * rounded down, except for 2^31, whose own would not fit an int32_t.
 */
static inline int32_t qtri_reciprocal_below(uint32_t x)
{
#if QTRI_LONG_MULTIPLY && QTRI_DIVIDE
    /*
     * With d = x / 2^32, s = 1 / d within 2^-15: s (2 - d s) is never more than 1 / d, and at most
     * 2^-30 less; products cut off twice make it less than 4 units.
     */
    uint32_t s_q31 = (0x7FFFFFFFu / (x >> 16)) << 16;
    uint32_t two_less_q31 = ~qtri_mul_high32(x, s_q31);
    uint32_t r = qtri_mul_high32(s_q31, two_less_q31);
    uint64_t rest = ((uint64_t)1 << 62) - (uint64_t)x * r;
    while (rest > x) {
        rest -= x;
        r++;
    }
#else
    uint32_t r = qtri_reciprocal_q62(x);
    r -= r >> 31;
#endif
    int32_t reciprocal = (int32_t)r;
    QTRI_HOLD(reciprocal); /* signed, or GCC 12 forgets what smull is for */
    return reciprocal;
}

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
