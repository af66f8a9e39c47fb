/*
 * Rows of packed colours, for functions that draw part of a row. Internal.
 */
#ifndef QTRI_RASTER_FILL_PACKED_H
#define QTRI_RASTER_FILL_PACKED_H

#include "fill.h"
#include "packed.h"

/* How far a row is drawn: its place in memory, and its depth. */
typedef struct qtri_cursor {
    uint16_t *pixel, *depth;
    uint32_t z;
} qtri_cursor;

/* Draws `count` > 0 pixels from the first of a group of eight on. */
typedef void (*qtri_packed_draw)(qtri_cursor *at, const qtri_job *job, uint32_t packed,
                                 int32_t count);

/* A pixel in the middle of a group, where a scissor cuts a span. */
static inline void qtri_packed_draw_one(qtri_cursor *at, const qtri_job *job, uint32_t packed)
{
    if (at->z >> 16 < *at->depth) {
        *at->depth = (uint16_t)(at->z >> 16);
        *at->pixel = (uint16_t)qtri_packed_pixel(packed);
    }
    at->z += job->depth.dx;
    at->depth++;
    at->pixel++;
}

/*
 * Pixels `skip` .. skip + rest - 1 of a run of a span, and the runs after it. The exact starts are
 * those of qtri_packed_start: a ramp stepped by a run's length is the ramp there, modulo 2^32.
 */
static inline void qtri_packed_runs(qtri_cursor *at, const qtri_job *job, int32_t dx, int32_t dy,
                                    int32_t skip, int32_t rest, qtri_packed_draw draw)
{
    const qtri_ramp *ramp = job->color.ramp;
    uint32_t r = qtri_ramp_at(&ramp[0], dx - skip, dy);
    uint32_t g = qtri_ramp_at(&ramp[1], dx - skip, dy);
    uint32_t b = qtri_ramp_at(&ramp[2], dx - skip, dy);
    for (;;) {
        uint32_t packed = qtri_pack_floor(r, g, b);
        int32_t part = QTRI_PACKED_RUN - skip < rest ? QTRI_PACKED_RUN - skip : rest;
        rest -= part;
        if (skip != 0) {
            for (; part > 0 && skip % 8 != 0; part--, skip++) {
                qtri_packed_draw_one(at, job, packed + qtri_packed_skip(job, skip));
            }
            packed += qtri_packed_skip(job, skip);
            skip = 0;
        }
        if (part > 0) {
            draw(at, job, packed, part);
        }
        if (rest <= 0) {
            return;
        }
        r += QTRI_PACKED_RUN * ramp[0].dx;
        g += QTRI_PACKED_RUN * ramp[1].dx;
        b += QTRI_PACKED_RUN * ramp[2].dx;
    }
}

/* Rows of a triangle that is not tiny. */
static inline void qtri_packed_rows(const qtri_job *job, const qtri_span *spans, int32_t row,
                                    int32_t count, qtri_packed_draw draw)
{
    const qtri_raster *raster = job->raster;
    qtri_lines lines = qtri_lines_at(raster->surface, row);
    for (const qtri_span *end = spans + count; spans < end; spans++, row++) {
        int32_t x;
        int32_t rest = qtri_span_clip(spans, &raster->bounds, &x);
        if (rest > 0) {
            int32_t dx = x - job->anchor_x;
            int32_t dy = row - job->anchor_y;
            qtri_cursor at = {(uint16_t *)(void *)lines.pixels + x, lines.depths + x,
                              qtri_ramp_at(&job->depth, dx, dy)};
            qtri_packed_runs(&at, job, dx, dy, (x - spans->left) % QTRI_PACKED_RUN, rest, draw);
        }
        QTRI_NEXT_ROW
        lines.pixels += raster->surface->pitch;
        lines.depths += raster->surface->depth_pitch;
    }
}

#endif
