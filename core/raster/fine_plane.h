/* SPDX-License-Identifier: MIT */
/*
 * Planes of attributes that are divided by each other: finer than gradient.h's. Internal.
 *
 * A floor that begins behind the eye is cut at the near plane: its vertices lie some thousand
 * pixels outside of the frame, where 1/w is many times of what it is inside. A step that is off by
 * 2^-9 of a unit a pixel, as a plane's may be, is then off by units in the frame, where few bits
 * of 1/w are left.
 */
#ifndef QTRI_RASTER_FINE_PLANE_H
#define QTRI_RASTER_FINE_PLANE_H

#include "gradient.h"

/* In 2^-30 of the attribute's unit, modulo 2^34 of it: at the centre of pixel (0, 0), and steps. */
typedef struct qtri_fine_plane {
    uint64_t origin, dx, dy;
} qtri_fine_plane;

/* What all planes of a triangle are divided by. */
typedef struct qtri_divisor {
    uint64_t size; /* of |area| 2^zeros, 2^62 <= size < 2^63 */
    int32_t zeros;
    int32_t reciprocal; /* 2^93 / size, rounded down */
    bool negative;
    int32_t wide; /* bits that values lose, so that products fit */
} qtri_divisor;

/*
 * False where a fine plane would not hold: slopes of 2^31 units a pixel and more, as slivers less
 * than a pixel thick may have. `extent`: width and height of the triangle, 1/256 pixel, added.
 */
bool qtri_divisor_init(qtri_divisor *area, const qtri_gradient *gradient, int32_t extent);

/* The plane through (vertex i, f[i]) for 0 <= f < 2^39, in 2^-8 units. */
void qtri_fine_plane_init(qtri_fine_plane *plane, const qtri_gradient *gradient,
                          const qtri_divisor *area, const int64_t f_q8[3]);

/* At the centre of a pixel: 2^-30. */
static inline uint64_t qtri_fine_plane_at(const qtri_fine_plane *plane, int32_t x, int32_t y)
{
    return plane->origin + plane->dx * (uint64_t)(int64_t)x + plane->dy * (uint64_t)(int64_t)y;
}

#endif
