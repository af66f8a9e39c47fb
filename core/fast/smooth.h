/* SPDX-License-Identifier: MIT */
/*
 * Rows of packed colours, for functions that draw part of a row. Internal.
 */
#ifndef QTRI_FAST_SMOOTH_H
#define QTRI_FAST_SMOOTH_H

#include "../raster/job.h"
#include "../raster/loop.h"
#include "../raster/packed.h"
#include "fused.h"

/* A row: what is left of a run, and the runs after it. */
typedef struct qtri_packed_row {
    uint16_t *pixel, *depth;
    uint32_t z;
    uint32_t packed;
    int32_t part;     /* pixels of the run, from the first of a group of eight on */
    int32_t rest;     /* pixels after it */
    uint32_t r, g, b; /* ramps where it starts */
} qtri_packed_row;

/*
 * The start of the next run, that of qtri_packed_start: a ramp stepped by a run's length is the
 * ramp there, modulo 2^32.
 */
static inline uint32_t qtri_packed_next(qtri_packed_row *row, const qtri_job *job)
{
    const qtri_attribute *color = job->attribute;
    row->r += QTRI_PACKED_RUN * color[0].ramp.dx;
    row->g += QTRI_PACKED_RUN * color[1].ramp.dx;
    row->b += QTRI_PACKED_RUN * color[2].ramp.dx;
    return qtri_pack_floor(row->r, row->g, row->b);
}

static inline int32_t qtri_packed_part(int32_t rest)
{
    return rest < QTRI_PACKED_RUN ? rest : QTRI_PACKED_RUN;
}

/* Draws them; 0 < part. */
typedef void (*qtri_packed_draw)(qtri_packed_row *row, const qtri_job *job);

/*
 * Where a scissor cuts off `skip` pixels of the first run: draws up to the next group. False when
 * that was all.
 */
bool qtri_packed_cut(qtri_packed_row *row, const qtri_job *job, int32_t skip, bool equal);

/* One pixel after the other. */
void qtri_packed_singly(qtri_packed_row *row, const qtri_job *job);
void qtri_packed_singly_equal(qtri_packed_row *row, const qtri_job *job);

/* Fewer pixels than a group has, from its first on: meshes have many such rows. */
static inline void qtri_packed_short(const qtri_job *job, uint16_t *pixel, uint16_t *depth,
                                     int32_t count, uint32_t z, uint32_t packed, bool equal)
{
    const uint32_t depth_step = job->depth.dx;
    const uint32_t two_steps = job->color.step.even + job->color.step.odd;
    uint32_t step = job->color.step.even;
    const uint16_t *stop = depth + count;
    do {
        if (qtri_passes(z >> 16, *depth, equal)) {
            QTRI_BRANCH
            *depth = (uint16_t)(z >> 16);
            *pixel = (uint16_t)qtri_packed_pixel(packed);
        }
        z += depth_step;
        packed += step;
        step = two_steps - step;
        depth++;
        pixel++;
    } while (depth != stop);
}

/* equal: what passes, as `draw` has it. */
QTRI_IN_PLACE void qtri_packed_rows(const qtri_job *job, const qtri_span *spans, int32_t row,
                                    int32_t count, qtri_packed_draw draw, bool equal)
{
    const qtri_raster *raster = job->raster;
    const qtri_attribute *color = job->attribute;
    qtri_lines lines = qtri_lines_at(raster->surface, row);
    for (const qtri_span *end = spans + count; spans < end; spans++, row++) {
        int32_t x;
        int32_t rest = qtri_span_clip(spans, &raster->bounds, &x);
        if (rest > 0) {
            int32_t dy = row - job->anchor_y;
            int32_t skip = (x - spans->left) & (QTRI_PACKED_RUN - 1);
            int32_t dx = x - skip - job->anchor_x;
            uint16_t *pixel = (uint16_t *)(void *)lines.pixels + x;
            uint16_t *depth = lines.depths + x;
            uint32_t z = qtri_ramp_at(&job->depth, x - job->anchor_x, dy);
            uint32_t r = qtri_ramp_at(&color[0].ramp, dx, dy);
            uint32_t g = qtri_ramp_at(&color[1].ramp, dx, dy);
            uint32_t b = qtri_ramp_at(&color[2].ramp, dx, dy);
            uint32_t packed = qtri_pack_floor(r, g, b);
            if (skip == 0 && rest < 8) {
                qtri_packed_short(job, pixel, depth, rest, z, packed, equal);
            } else {
                int32_t part = QTRI_PACKED_RUN - skip < rest ? QTRI_PACKED_RUN - skip : rest;
                qtri_packed_row at = {pixel, depth, z, packed, part, rest - part, r, g, b};
                if (skip == 0 || qtri_packed_cut(&at, job, skip, equal)) {
                    draw(&at, job);
                }
            }
        }
        QTRI_READ_AGAIN
        lines.pixels += raster->surface->pitch;
        lines.depths += raster->surface->depth_pitch;
    }
}

#endif
