/* SPDX-License-Identifier: MIT */
/*
 * Levels of textures along large triangles: what they are found by. Internal.
 */
#ifndef QTRI_RASTER_LARGE_LEVELS_H
#define QTRI_RASTER_LARGE_LEVELS_H

#include "qtri/body/large.h"

/* The length of a step, of the magnitudes of both its parts: .97 to 1.07 of it. */
static inline uint32_t qtri_step_length_of(uint32_t a, uint32_t b)
{
    return a > b ? a + (3 * (b >> 3)) : b + (3 * (a >> 3));
}

/* Once planes are set. */
void qtri_large_set_footprint(qtri_footprint_plane *out, const qtri_large_job *job);

#endif
