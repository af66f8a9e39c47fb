/* SPDX-License-Identifier: MIT */
/*
 * Of a texture that is mipmapped: which of its levels is drawn. Internal.
 *
 * The raster's texture is a copy of the material's, of which texels and sides change with the
 * level, and with them what the raster has of those: all stages draw what they find there.
 */
#ifndef QTRI_RASTER_LEVELS_H
#define QTRI_RASTER_LEVELS_H

#include "texel_axis.h"

struct qtri_raster;

/*
 * What the footprint of a large triangle with perspective is made of, see footprint.c: along each
 * axis the steps right and down, times q^2, in 2^-exponent of 2^(3/2) texels; |.| < 2^28 where the
 * triangle is in the frame.
 */
typedef struct qtri_footprint {
    uint32_t right[2], right_dy[2]; /* in row 0, for one row down */
    uint32_t down[2], down_dx[2];   /* in column 0, for one column right */
    uint32_t along, along_dx;       /* straight: the step down's length, as `down` and `down_dx` */
    bool straight;                  /* it is linear in x */
    int16_t before;                 /* the exponent, less 22 */
    int16_t row;                    /* that was last asked for; -1: none */
    uint32_t length;                /* of its step right */
} qtri_footprint;

typedef struct qtri_levels {
    qtri_texture texture;                /* the raster's */
    const qtri_texture *whole;           /* the material's */
    struct qtri_raster *raster;          /* the one that has this */
    const struct qtri_texturing *stages; /* two of them: see qtri_levels_vary */
    qtri_texel_axis *axis;               /* those that change with the level too; NULL: none */
    uint8_t level, last;                 /* now, and the smallest */
    uint8_t waiting;                     /* of the fragments in the batch */
    uint8_t down[2];                     /* what a level takes away from the log2 of its sides */
    qtri_footprint footprint;
} qtri_levels;

#endif
