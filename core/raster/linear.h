/* SPDX-License-Identifier: MIT */
/*
 * Attributes that are linear on the screen, along rows. Internal.
 */
#ifndef QTRI_RASTER_LINEAR_H
#define QTRI_RASTER_LINEAR_H

#include "job.h"

/* Texture coordinates, before the first row that is filled. */
void qtri_linear_begin(qtri_scanline *row);

/* A qtri_interpolate. */
int32_t qtri_interpolate_linear(qtri_scanline *row, int32_t x, int32_t count, int first, int end,
                                qtri_curve *out);

/* Up to where coordinates step from the start that they have at x: for texels that fill 32 bits. */
int32_t qtri_run_end(const qtri_scanline *row, int32_t x);

#endif
