/* SPDX-License-Identifier: MIT */
/*
 * Attributes that are linear on the screen, along rows. Internal.
 */
#ifndef QTRI_RASTER_LINEAR_H
#define QTRI_RASTER_LINEAR_H

#include "job.h"

/* Before the first row that is filled. */
void qtri_linear_begin(qtri_scanline *row);

/* Coordinates where a run begins: at pixel x. */
void qtri_linear_start(qtri_scanline *row, int32_t x);

/*
 * Texture coordinates at a pixel of the row. Returns where their run ends; along a level row they
 * are one, which perspective.c began at the span's left end.
 */
int32_t qtri_linear_texels(qtri_scanline *row, int32_t x);

/* All attributes at the first chunk of a row; then at the chunk after, which begins at x. */
void qtri_linear_row(qtri_scanline *row, int32_t x);

static inline void qtri_linear_next(qtri_scanline *row, int32_t x)
{
    const qtri_job *job = row->job;
    qtri_curve *curve = &row->curve[job->first];
    for (const qtri_curve *end = &row->curve[job->end]; curve != end; curve++) {
        curve->at += curve->step * QTRI_BATCH;
    }
    if (job->end == QTRI_ATTRIBUTES && ((x - row->left) & (row->run_length - 1)) == 0) {
        qtri_linear_start(row, x);
    }
}

#endif
