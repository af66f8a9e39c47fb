/* SPDX-License-Identifier: MIT */
/*
 * Attributes that are linear on the screen. Internal.
 *
 * Two forms. A plane holds 64 bits and serves any triangle and any attribute. A ramp holds 32, for
 * attributes that are n.16 and leave at most 16 bits before the point: stepping one is a single
 * addition. All sums are meant to wrap: a sliver's gradient may be enormous, but at the pixels that
 * the triangle covers the true value lies between its vertices' values, and arithmetic modulo a
 * power of two gets there whatever the way.
 */
#ifndef QTRI_RASTER_GRADIENT_H
#define QTRI_RASTER_GRADIENT_H

#include <stdbool.h>
#include <stdint.h>

#include "../bits/reciprocal.h"

/* Where the vertices are; what all gradients of one triangle have in common. */
typedef struct qtri_gradient {
    int32_t x_24p8, y_24p8;       /* vertex 0 */
    int32_t dx1, dy1, dx2, dy2;   /* vertices 1 and 2 from there, 1/256 pixel, |.| <= 2^23 */
    int64_t area;                 /* dx1 dy2 - dx2 dy1, not 0, |.| <= 2^47 */
    int32_t anchor_x, anchor_y;   /* origin of the ramps: a pixel */
    int32_t anchor_dx, anchor_dy; /* its centre from vertex 0, 1/256 pixel */
    /* Triangles below 128 pixels: 2^61 / (|area| 2^zeros), in [2^29, 2^30); others: 0. */
    int32_t reciprocal, zeros;
    /* Of them those that are no slivers: 2^17 / area = inverse 2^(left - 32); others: 0. */
    int32_t inverse, left;
} qtri_gradient;

/*
 * A plane in 2^-16 of the attribute's own unit. Error at a covered pixel: the gradient per
 * sub-pixel is rounded to 2^-17; across the whole guard band, 2^23 sub-pixels in x and in y, that
 * is at most 2^7 units of 2^0 of the attribute. Attributes carry 16 bits and more below what can be
 * seen.
 */
typedef struct qtri_plane {
    uint64_t origin; /* at the centre of pixel (0, 0) */
    uint64_t dx, dy; /* for one pixel to the right, one pixel down */
} qtri_plane;

/*
 * A ramp's origin is the anchor, with half a unit added so that a shift rounds. A step is off by
 * 2^-17 of a unit at most, so 8192 x 8192 pixels away by an eighth.
 */
typedef struct qtri_ramp {
    uint32_t origin;
    uint32_t dx, dy;
} qtri_ramp;

/*
 * Prepares what all attributes share but the anchor; x_24p8 .. area are set. `extent`: width and
 * height of the triangle, 1/256 pixel, added.
 */
void qtri_gradient_init(qtri_gradient *gradient, int32_t extent);

/* The plane through (vertex i, f[i]). */
void qtri_plane_init(qtri_plane *plane, const qtri_gradient *gradient, const uint32_t f[3]);

/* The attribute in its own unit, rounded down. */
static inline int64_t qtri_plane_floor(uint64_t value)
{
    return qtri_wrap64(value) >> 16;
}

/* The ramp through (vertex i, f[i]): n.16, any 32 bits. By exact division. */
void qtri_ramp_divide(qtri_ramp *ramp, const qtri_gradient *gradient, const uint32_t f[3]);

/*
 * Ramps of small triangles, |d| < 2^15 for the four differences, that are no slivers, and of
 * attributes whose own differences fit, take one product of 32 bits a step. No sliver:
 * |area| >= 32 extent >= 16 s with s the sum of the differences' magnitudes. Without the
 * attribute's last QTRI_RAMP_DOWN bits its numerator n = f1 d - f2 d' is at most 2^14 2^16, and its
 * gradient a pixel, with r = 2^61 / (|area| 2^zeros),
 *
 *     256 2^QTRI_RAMP_DOWN n / area = n r / 2^shift, shift = 44 - zeros
 *
 * is at most 2^8 2^23 s / 16 s = 2^27. That is the high word of (n 2^(32 - shift)) r or of
 * n (r 2^(32 - shift)), whichever shifts left: in the first n <= 2^27 2^shift / r, so that the
 * product's left factor is at most 2^30; in the second r loses bits, which costs n / 2^32: less
 * than a unit.
 */
static inline bool qtri_gradient_is_sliver(uint32_t size, int32_t extent)
{
    return size < (uint32_t)extent << 5;
}

/* That r, or r 2^(32 - shift), of a positive area; *left is 32 - shift where n is shifted. */
static inline int32_t qtri_gradient_inverse(int32_t r, int32_t zeros, int32_t *left)
{
    const int32_t up = zeros - 12; /* 32 - shift <= 16: size >= 16 */
    *left = up < 0 ? 0 : up;
    return up < 0 ? (r + ((int32_t)1 << (-1 - up))) >> -up : r;
}

static inline void qtri_gradient_set_inverse(qtri_gradient *g, int32_t r, int32_t zeros)
{
    const int32_t inverse = qtri_gradient_inverse(r, zeros, &g->left);
    g->inverse = g->area < 0 ? -inverse : inverse;
}

/* Bits of a difference that do not count in a small triangle. */
#define QTRI_RAMP_DOWN 9

/* numerator 2^(8 + QTRI_RAMP_DOWN) / area. */
static inline int32_t qtri_gradient_step(const qtri_gradient *g, int32_t numerator)
{
    return (int32_t)(qtri_mul_s32(numerator * ((int32_t)1 << g->left), g->inverse) >> 32);
}

/* floor((gx x + gy y) / 256), |x|, |y| < 2^16, modulo 2^32. */
static inline uint32_t qtri_gradient_along(int32_t gx, int32_t x, int32_t gy, int32_t y)
{
#if QTRI_LONG_MULTIPLY
    return (uint32_t)(((int64_t)gx * x + (int64_t)gy * y) >> 8);
#else
    int32_t rest = (gx & 255) * x + (gy & 255) * y; /* < 2^25 */
    uint32_t whole = (uint32_t)(gx >> 8) * (uint32_t)x + (uint32_t)(gy >> 8) * (uint32_t)y;
    return whole + (uint32_t)(rest >> 8);
#endif
}

/* Whether the difference may go the short way: it is below 2^23 + 2^8. */
static inline bool qtri_ramp_fits(uint32_t a, uint32_t b)
{
    return (a >> 8) - (b >> 8) + ((uint32_t)1 << 15) < (uint32_t)1 << 16;
}

/*
 * The same as qtri_ramp_divide for differences f1 and f2 from f0 without QTRI_RAMP_DOWN bits, where
 * the gradient has an inverse.
 */
static inline void qtri_ramp_from_steps(qtri_ramp *ramp, const qtri_gradient *g, uint32_t f0,
                                        int32_t f1, int32_t f2)
{
    int32_t gx = qtri_gradient_step(g, f1 * g->dy2 - f2 * g->dy1);
    int32_t gy = qtri_gradient_step(g, f2 * g->dx1 - f1 * g->dx2);
    ramp->origin = f0 + qtri_gradient_along(gx, g->anchor_dx, gy, g->anchor_dy) + 0x8000u;
    ramp->dx = (uint32_t)gx;
    ramp->dy = (uint32_t)gy;
}

static inline int32_t qtri_ramp_down(uint32_t difference)
{
    return ((int32_t)difference + ((int32_t)1 << (QTRI_RAMP_DOWN - 1))) >> QTRI_RAMP_DOWN;
}

/* Differences fit. */
static inline void qtri_ramp_multiply(qtri_ramp *ramp, const qtri_gradient *g, const uint32_t f[3])
{
    qtri_ramp_from_steps(ramp, g, f[0], qtri_ramp_down(f[1] - f[0]), qtri_ramp_down(f[2] - f[0]));
}

/* dx and dy: pixels from the anchor. */
static inline uint32_t qtri_ramp_at(const qtri_ramp *ramp, int32_t dx, int32_t dy)
{
    return ramp->origin + (uint32_t)dx * ramp->dx + (uint32_t)dy * ramp->dy;
}

/* The least and the greatest of the three vertices' values. */
static inline void qtri_find_range(uint32_t *least, uint32_t *greatest, const uint32_t f[3])
{
    *least = f[0];
    *greatest = f[0];
    for (int i = 1; i < 3; i++) {
        *least = f[i] < *least ? f[i] : *least;
        *greatest = f[i] > *greatest ? f[i] : *greatest;
    }
}

#endif
