/* SPDX-License-Identifier: MIT */
/*
 * What is linear on the screen over a small triangle. Internal.
 */
#ifndef QTRI_RASTER_PLACE_RAMP_H
#define QTRI_RASTER_PLACE_RAMP_H

#include "../bits/reciprocal.h"
#include "gradient.h"
#include "place.h"

/*
 * What turns numerators into steps: 1 / size, of 16 bits. It is off by 2^-14.4 of itself, so a ramp
 * is at a vertex by that much of its range.
 *
 *     x = size 2^zeros / 2^16, rounded, in 2^15..2^16; y = 2^31 / x, rounded down
 *     n 2^16 / size = n y / 2^17 / 2^down, down = 14 - zeros
 */
typedef struct qtri_inverse {
    int32_t y; /* times 2^15 where a long product is an instruction */
    int32_t down;
} qtri_inverse;

static inline void qtri_inverse_init(qtri_inverse *inverse, uint32_t size)
{
    const int32_t zeros = qtri_clz32(size | 1u);
    uint32_t y = qtri_reciprocal_q31(((size << zeros >> 1) + ((uint32_t)1 << 14)) >> 15);
    y -= y >> 16;
    inverse->y = (int32_t)(QTRI_LONG_MULTIPLY ? y << 15 : y);
    inverse->down = 14 - zeros;
}

/* n y / 2^17 / 2^down, rounded down. |n| < 2^30.5. */
static inline int32_t qtri_inverse_step(const qtri_inverse *by, int32_t n, int32_t down)
{
#if QTRI_LONG_MULTIPLY
    return (int32_t)(qtri_mul_s32(n, by->y) >> 32) >> down;
#else
    const uint32_t low = qtri_low16((uint32_t)n) * (uint32_t)by->y;
    return ((n >> 16) * by->y + (int32_t)(low >> 16)) >> (down + 1);
#endif
}

/* Bits of a difference that do not count. */
#define QTRI_PLACE_DOWN 8

/*
 * Numerators of an attribute's steps a pixel along x and y, from its differences at vertices 1 and
 * 2 without those bits. |f| <= 2^16: at most 2^16 18432 < 2^30.2.
 */
static inline int32_t qtri_place_nx(const qtri_place *p, int32_t f1, int32_t f2)
{
    return f2 * p->dy1 - f1 * p->dy2;
}

static inline int32_t qtri_place_ny(const qtri_place *p, int32_t f1, int32_t f2)
{
    return f1 * p->dx2 - f2 * p->dx1;
}

/* The ramp from the base on with these steps, which is f0 at vertex 0. A base may be pixel (0, 0):
   what touches a pixel is less than 2^21.1 of 1/256 pixel away from there. */
static inline void qtri_place_ramp_set(qtri_ramp *ramp, const qtri_place *p, uint32_t f0,
                                       int32_t gx, int32_t gy)
{
    ramp->origin = f0 + qtri_gradient_along(gx, p->x, gy, p->y);
    ramp->dx = (uint32_t)gx;
    ramp->dy = (uint32_t)gy;
}

/* Of any triangle, |f| < 2^24: off by 2^11 at most, and 2^-14 of the range. */
void qtri_place_ramp_any(qtri_ramp *ramp, const qtri_place *p, uint32_t f0, int32_t f1, int32_t f2);

/* The same by copies: what no address is taken of stays in registers. */
static inline void qtri_place_ramp_rare(qtri_ramp *ramp, const qtri_place *p, uint32_t f0,
                                        int32_t f1, int32_t f2)
{
    const qtri_place place = *p;
    qtri_ramp result;
    QTRI_RARELY();
    qtri_place_ramp_any(&result, &place, f0, f1, f2);
    *ramp = result;
}

/* |f| <= 2^16. */
static inline void qtri_place_ramp(qtri_ramp *ramp, const qtri_place *p, const qtri_inverse *by,
                                   uint32_t f0, int32_t f1, int32_t f2)
{
    if (by->down >= 0) {
        const int32_t gx = qtri_inverse_step(by, qtri_place_nx(p, f1, f2), by->down);
        const int32_t gy = qtri_inverse_step(by, qtri_place_ny(p, f1, f2), by->down);
        qtri_place_ramp_set(ramp, p, f0, gx, gy);
    } else {
        qtri_place_ramp_rare(ramp, p, f0, f1, f2);
    }
}

/*
 * Depth, 16.16 with the half that rounds; b and c in the order of the place. False when it `asks`
 * and depth is steep: what qtri_place_near() finds small is not.
 */
static inline bool qtri_place_depth(qtri_ramp *ramp, const qtri_place *p, const qtri_inverse *by,
                                    const qtri_vertex *a, const qtri_vertex *b,
                                    const qtri_vertex *c, bool asks)
{
    const uint32_t z0 = a->depth_16p8 >> 8;
    const int32_t z1 = (int32_t)((b->depth_16p8 >> 8) - z0);
    const int32_t z2 = (int32_t)((c->depth_16p8 >> 8) - z0);
    const uint32_t f0 = (a->depth_16p8 & ~0xFFu) + 0x8000u;
    if ((qtri_about(z1) | qtri_about(z2)) >> 16 == 0) {
        qtri_place_ramp(ramp, p, by, f0, z1, z2);
        return true;
    }
    if (asks && qtri_place_is_steep(p, z1, z2)) {
        return false;
    }
    qtri_place_ramp_rare(ramp, p, f0, z1, z2);
    return true;
}

#endif
