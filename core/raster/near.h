/* SPDX-License-Identifier: MIT */
/*
 * Rows of small triangles, along curves that take no division. Internal.
 */
#ifndef QTRI_RASTER_NEAR_H
#define QTRI_RASTER_NEAR_H

#include "job.h"

/* The greatest steps of e, Q26, where blocks have 32 pixels, and 16: see near.c. */
enum {
    QTRI_NEAR_STEEP_32 = ((int32_t)1 << 26) / 768,
    QTRI_NEAR_STEEP_16 = ((int32_t)1 << 26) / 248
};

/* As qtri_interpolate_perspective, for a job with values. */
int32_t qtri_interpolate_near(qtri_scanline *row, int32_t x, int32_t count, int first, int end);

#endif
