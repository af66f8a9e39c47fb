/*
 * Attributes that are linear on the screen. Internal.
 *
 * An attribute f is a plane over the pixel grid, evaluated in 64 bits with 16 bits below the
 * attribute's own unit. The sums are meant to wrap: a sliver's gradient may be enormous, but at the
 * pixels that the triangle covers the true value lies between its vertices' values, and arithmetic
 * modulo 2^64 gets there whatever the way.
 *
 * Error at a covered pixel: the gradient per sub-pixel is rounded to 2^-17; across the whole guard
 * band, 2^23 sub-pixels in x and in y, that is at most 2^7 units of 2^0 of the attribute.
 * Attributes carry 16 bits and more below what can be seen.
 */
#ifndef QTRI_RASTER_PLANE_H
#define QTRI_RASTER_PLANE_H

#include <stdint.h>

#include "../math/bits.h"

typedef struct qtri_plane {
    uint64_t origin; /* at the centre of pixel (0, 0), in 2^-16 units */
    uint64_t dx, dy; /* for one pixel to the right, one pixel down */
} qtri_plane;

/* What gradients of one triangle have in common. */
typedef struct qtri_plane_base {
    int32_t x_24p8, y_24p8;     /* vertex 0 */
    int32_t dx1, dy1, dx2, dy2; /* vertices 1 and 2 from there, 1/256 pixel, |.| <= 2^23 */
    int64_t area;               /* dx1 dy2 - dx2 dy1, not 0, |.| <= 2^47 */
} qtri_plane_base;

/* The plane through (vertex i, f[i]), |f| < 2^33. */
void qtri_plane_init(qtri_plane *plane, const qtri_plane_base *base, const int64_t f[3]);

/* In 2^-16 units, at the centre of pixel (x, y). */
static inline uint64_t qtri_plane_at(const qtri_plane *plane, int32_t x, int32_t y)
{
    return plane->origin + (uint64_t)(int64_t)x * plane->dx + (uint64_t)(int64_t)y * plane->dy;
}

/* The attribute in its own unit, rounded down. */
static inline int64_t qtri_plane_floor(uint64_t value)
{
    return qtri_wrap64(value) >> 16;
}

/*
 * A plane in 32 bits, for attributes that are n.16 and leave at most 16 bits before the point:
 * stepping one is a single addition. Its origin is a pixel of the frame, exact, with half a unit
 * added so that a shift rounds; a step is off by 2^-17 of a unit at most, so 8192 x 8192 pixels
 * away by an eighth. Sums wrap, as those of planes do.
 */
typedef struct qtri_ramp {
    uint32_t origin;
    uint32_t dx, dy;
} qtri_ramp;

/* x, y: the pixel that becomes the origin. */
void qtri_ramp_init(qtri_ramp *ramp, const qtri_plane *plane, int32_t x, int32_t y);

/* dx and dy: pixels from the origin. */
static inline uint32_t qtri_ramp_at(const qtri_ramp *ramp, int32_t dx, int32_t dy)
{
    return ramp->origin + (uint32_t)dx * ramp->dx + (uint32_t)dy * ramp->dy;
}

#endif
