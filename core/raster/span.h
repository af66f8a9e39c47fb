/*
 * What spans with and without perspective share. Internal.
 */
#ifndef QTRI_RASTER_SPAN_H
#define QTRI_RASTER_SPAN_H

#include "fill.h"

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

/* Where the pixels of a row are; depths NULL: neither read nor written. */
static inline void qtri_run_set_row(qtri_run *run, const qtri_raster *raster, int32_t row)
{
    run->pixels = qtri_pixels_at(raster->surface, row);
    run->depths = raster->compare != QTRI_DEPTH_OFF ? qtri_depths_at(raster->surface, row) : NULL;
}

static inline void qtri_run_next_row(qtri_run *run, const qtri_surface *surface)
{
    run->pixels += surface->pitch;
    if (run->depths != NULL) {
        run->depths += surface->depth_pitch;
    }
}

/* Place and values are set, depth follows from them. */
static inline void qtri_run_draw(const qtri_job *job, qtri_run *run, int32_t y)
{
    run->z = qtri_ramp_at(&job->depth, run->x - job->anchor_x, y - job->anchor_y);
    job->draw_run(job, run);
}

#endif
