/* SPDX-License-Identifier: MIT */
#include "linear.h"

enum {
    LINEAR_RUN = 512
}; /* pixels along which coordinates that fill 32 bits step from one start */

/*
 * Linear coordinates start anew from their planes: steps lose what a long run would show. Those
 * that fill 32 bits leave 2^-17 of a texel and less to the last bit, others start with every chunk.
 */
static void start_run(qtri_scanline *row, int32_t x)
{
    const qtri_job *job = row->job;
    row->run = x;
    for (int i = 0; i < 2; i++) {
        const uint64_t value =
            qtri_plane_column(row->by.plane[i], job->attribute[QTRI_U + i].plane.dx, x);
        row->uv[i].at = qtri_run_scaled((uint32_t)qtri_plane_floor(value), job->axis[i].up);
    }
}

/* The start of the run that x lies in. */
static inline int32_t run_of(const qtri_scanline *row, int32_t x)
{
    const int32_t length = row->job->raster->repeated ? LINEAR_RUN : QTRI_BATCH;
    return row->level ? row->left : x - ((x - row->left) & (length - 1));
}

int32_t qtri_interpolate_linear(qtri_scanline *row, int32_t x, int32_t count, int first, int end,
                                qtri_curve *out)
{
    const qtri_job *job = row->job;
    for (int i = first; i < end && i < QTRI_U; i++, out++) {
        const qtri_ramp *ramp = &job->attribute[i].ramp;
        out->at = qtri_ramp_at(ramp, x - job->anchor_x, row->y - job->anchor_y);
        out->step = ramp->dx;
        out->bend = 0;
        out->twist = 0;
    }
    if (end == QTRI_ATTRIBUTES) {
        const int32_t run = run_of(row, x);
        if (row->run != run) {
            start_run(row, run);
        }
        for (int i = 0; i < 2; i++, out++) {
            out->at = row->uv[i].at + (uint32_t)(x - run) * row->uv[i].step;
            out->step = row->uv[i].step;
            out->bend = 0;
            out->twist = 0;
        }
    }
    return count;
}

int32_t qtri_run_end(const qtri_scanline *row, int32_t x)
{
    return row->level ? row->right : run_of(row, x) + LINEAR_RUN;
}

/* A plane's step in the attribute's unit times 2^up, rounded. */
static uint32_t plane_step(uint64_t dx, int32_t up)
{
    int32_t down = 16 - up; /* -4..28: what is shifted in does not get to the low 32 bits */
    return (uint32_t)(down > 0 ? ((dx >> (down - 1)) + 1) >> 1 : dx << -down);
}

void qtri_linear_begin(qtri_scanline *row)
{
    const qtri_job *job = row->job;
    for (int i = 0; i < 2; i++) {
        const qtri_plane *plane = &job->attribute[QTRI_U + i].plane;
        row->by.plane[i] = qtri_plane_row(plane, row->y) + ((uint64_t)job->axis[i].bias << 16);
        row->uv[i].step = plane_step(plane->dx, job->axis[i].up);
    }
}
