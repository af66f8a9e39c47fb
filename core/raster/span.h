/*
 * What spans with and without perspective share. Internal.
 */
#ifndef QTRI_RASTER_SPAN_H
#define QTRI_RASTER_SPAN_H

#include "job.h"

/* A plane at column 0 of a row; then at a column. */
static inline uint64_t qtri_plane_row(const qtri_plane *plane, int32_t y)
{
    return plane->origin + (uint64_t)(int64_t)y * plane->dy;
}

static inline uint64_t qtri_plane_column(uint64_t row, uint64_t dx, int32_t x)
{
    return row + (uint64_t)(int64_t)x * dx;
}

/* An attribute in the unit of a run. */
static inline uint32_t qtri_run_scaled(uint32_t value, int32_t up)
{
    return up >= 0 ? value << up : value >> -up;
}

/*
 * The pixels x0..x1-1 of row y, at least one, of a span that covers left..right-1, where paint is
 * QTRI_PAINT_PERSPECTIVE; the rows of `run` are set. Where the exact divisions fall depends on left
 * and right alone, so that a scissor does not change a pixel.
 */
void qtri_span_perspective(const qtri_job *job, qtri_run *run, int32_t y, const qtri_span *span,
                           int32_t x0, int32_t x1);

#endif
