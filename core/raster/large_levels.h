/* SPDX-License-Identifier: MIT */
/*
 * Levels of textures along large triangles: what they are found by. Internal.
 */
#ifndef QTRI_RASTER_LARGE_LEVELS_H
#define QTRI_RASTER_LARGE_LEVELS_H

#include "qtri/body/large.h"

struct qtri_large_job;

/*
 * What the footprint of a triangle with perspective is made of, see large_footprint.c: along each
 * axis the steps right and down, times q^2, in 2^-exponent of 2^(1/2) texels; |.| < 2^28 where the
 * triangle is in the frame.
 */
typedef struct qtri_footprint_plane {
    uint32_t right[2], right_dy[2]; /* in row 0, for one row down */
    uint32_t down[2], down_dx[2];   /* in column 0, for one column right */
    uint32_t along, along_dx;       /* straight: the step down's length, as `down` and `down_dx` */
    bool straight;                  /* it is linear in x */
    int32_t before;  /* the shift of a length that is compared with q's square, see is_left() */
    uint32_t length; /* of the row's step right */
} qtri_footprint_plane;

/* Bits of q's square, and the shift by which a length of level 0 is compared with it. */
typedef struct qtri_footprint_measure {
    uint32_t square;
    int32_t before;
} qtri_footprint_measure;

typedef struct qtri_large_levels {
    qtri_clamp_axis axis[2]; /* those of level 0 */
    bool are_found;          /* along rows; false: `only` is that of the triangle */
    uint8_t only;            /* that, or the last one of a row along which w does not change */
    uint8_t run_log2;        /* of pixels along such a row that have one */
    qtri_footprint_measure measure; /* in such a row */
    qtri_footprint_plane footprint;
} qtri_large_levels;

/* The length of a step, of the magnitudes of both its parts: .97 to 1.07 of it. */
static inline uint32_t qtri_step_length_of(uint32_t a, uint32_t b)
{
    return a > b ? a + (3 * (b >> 3)) : b + (3 * (a >> 3));
}

/* Once planes are set. */
void qtri_large_set_footprint(qtri_footprint_plane *out, const struct qtri_large_job *job);

#endif
