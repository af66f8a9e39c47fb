/*
 * Rows of packed colours, for functions that draw part of a row. Internal.
 */
#ifndef QTRI_RASTER_FILL_PACKED_H
#define QTRI_RASTER_FILL_PACKED_H

#include "fill.h"
#include "packed.h"

/* A row of a triangle that is not tiny: what is left of a run, and the runs after it. */
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
    const qtri_ramp *ramp = job->color.ramp;
    row->r += QTRI_PACKED_RUN * ramp[0].dx;
    row->g += QTRI_PACKED_RUN * ramp[1].dx;
    row->b += QTRI_PACKED_RUN * ramp[2].dx;
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
bool qtri_packed_cut(qtri_packed_row *row, const qtri_job *job, int32_t skip);

/* One pixel after the other. */
void qtri_packed_singly(qtri_packed_row *row, const qtri_job *job);

static inline void qtri_packed_rows(const qtri_job *job, const qtri_span *spans, int32_t row,
                                    int32_t count, qtri_packed_draw draw)
{
    const qtri_raster *raster = job->raster;
    const qtri_ramp *ramp = job->color.ramp;
    qtri_lines lines = qtri_lines_at(raster->surface, row);
    for (const qtri_span *end = spans + count; spans < end; spans++, row++) {
        int32_t x;
        int32_t rest = qtri_span_clip(spans, &raster->bounds, &x);
        if (rest > 0) {
            int32_t dy = row - job->anchor_y;
            int32_t skip = (x - spans->left) & (QTRI_PACKED_RUN - 1);
            int32_t dx = x - skip - job->anchor_x;
            qtri_packed_row at;
            at.pixel = (uint16_t *)(void *)lines.pixels + x;
            at.depth = lines.depths + x;
            at.z = qtri_ramp_at(&job->depth, x - job->anchor_x, dy);
            at.r = qtri_ramp_at(&ramp[0], dx, dy);
            at.g = qtri_ramp_at(&ramp[1], dx, dy);
            at.b = qtri_ramp_at(&ramp[2], dx, dy);
            at.packed = qtri_pack_floor(at.r, at.g, at.b);
            at.part = QTRI_PACKED_RUN - skip < rest ? QTRI_PACKED_RUN - skip : rest;
            at.rest = rest - at.part;
            if (skip == 0 || qtri_packed_cut(&at, job, skip)) {
                draw(&at, job);
            }
        }
        QTRI_NEXT_ROW
        lines.pixels += raster->surface->pitch;
        lines.depths += raster->surface->depth_pitch;
    }
}

#endif
