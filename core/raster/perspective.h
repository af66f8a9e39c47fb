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
 * The job's planes and slopes. q: 1/w at the vertices, 2^31 or less; value: what texel.h made of
 * texture coordinates.
 */
void qtri_perspective_init(qtri_job *job, const qtri_triangle *triangle, const qtri_attributes v[3],
                           const uint32_t value[2][3], const uint32_t q[3],
                           const qtri_gradient *gradient, const qtri_unsnapped *unsnapped);

/* Before the first row; for every row with pixels to draw. */
void qtri_perspective_begin(qtri_scanline *row);
void qtri_perspective_row(qtri_scanline *row);

/*
 * Curves of attributes first..end - 1, colours or texture coordinates, not both, from pixel x of
 * the row on, which is not level, into row->curve. Returns for how many pixels they hold, up to
 * `count`. x is a chunk's first pixel or the one after those that the call before gave.
 */
int32_t qtri_interpolate_perspective(qtri_scanline *row, int32_t x, int32_t count, int first,
                                     int end);

/* A plane at a pixel of the row: |x| <= 2^14, so that products of the rest fit 31 bits. */
static inline uint32_t qtri_row_plane_at(const qtri_row_plane *row, const qtri_projected *plane,
                                         int32_t x)
{
    return row->at + plane->dx * (uint32_t)x +
           (uint32_t)((row->rest + (int32_t)plane->dx_rest * x) >> 16);
}

/* 1/w at a pixel of the row: where it is all but 0, rounding may leave it there or below. */
static inline uint32_t qtri_row_inv_w_at(const qtri_scanline *row, int32_t x)
{
    const qtri_job *job = row->job;
    const uint32_t q = qtri_row_plane_at(&row->by.perspective.plane[job->end],
                                         &job->attribute[job->end].projected, x);
    return q - 1 < 0xC0000000u ? q : 1;
}

/* Leading zeros of q, not 0: of the block before nearly as many. */
static inline int32_t qtri_row_zeros(qtri_scanline *row, uint32_t q)
{
#if QTRI_LONG_MULTIPLY
    (void)row;
    return qtri_clz32(q);
#else
    int32_t zeros = row->by.perspective.zeros;
    while (q >> (31 - zeros) > 1) {
        zeros--;
    }
    while ((int32_t)(q << zeros) >= 0) {
        zeros++;
    }
    row->by.perspective.zeros = zeros;
    return zeros;
#endif
}

#endif
