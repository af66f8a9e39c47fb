/* SPDX-License-Identifier: MIT */
/*
 * Attributes with perspective: set-up of a triangle, and curves along its rows. Internal.
 */
#ifndef QTRI_RASTER_PERSPECTIVE_H
#define QTRI_RASTER_PERSPECTIVE_H

#include "fine_plane.h"
#include "job.h"
#include "triangle.h"
#include "unsnapped.h"

/* Blocks of 2^this pixels and more of texels are of third order. */
#define QTRI_TWISTED_LOG2 4

/*
 * The job's planes and slopes. q: 1/w at the vertices, 2^31 or less; value: what texel_axis.h made
 * of texture coordinates.
 */
void qtri_perspective_init(qtri_job *job, const qtri_triangle *triangle, const qtri_attributes v[3],
                           const uint32_t value[2][3], const uint32_t q[3],
                           const qtri_gradient *gradient, const qtri_unsnapped *unsnapped);

/* Before the first row; for every row with pixels to draw. */
void qtri_perspective_begin(qtri_scanline *row);
void qtri_perspective_row(qtri_scanline *row);

#endif
