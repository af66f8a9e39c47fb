/* SPDX-License-Identifier: MIT */
/*
 * Depths of a row in formats that are linear along pieces of it: they are tested as those of
 * linear16 are, without a list of them. Internal; depth_rows.inc has the loops.
 */
#ifndef QTRI_RASTER_DEPTH_ROWS_H
#define QTRI_RASTER_DEPTH_ROWS_H

#include <stdint.h>

/* Ramps come with the half that rounds to 16 bits. */
#define QTRI_DEPTH_HALF     ((uint32_t)1 << 15)
#define QTRI_DEPTH_FARTHEST ((uint32_t)65535 << 16)

/* Neighbours that are stored as z >> down; z changes by `step` from one to the next. */
typedef struct qtri_depth_piece {
    uint32_t z, step, down;
} qtri_depth_piece;

/*
 * A ramp's value as a depth. Rounding may take it out of 0..65535.0 by less than the half that it
 * has, so it does not wrap.
 */
static inline uint32_t qtri_depth_of(uint32_t ramp)
{
    const uint32_t depth = ramp < QTRI_DEPTH_HALF ? 0 : ramp - QTRI_DEPTH_HALF;
    return depth < QTRI_DEPTH_FARTHEST ? depth : QTRI_DEPTH_FARTHEST;
}

#endif
