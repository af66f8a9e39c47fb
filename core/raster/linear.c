/* SPDX-License-Identifier: MIT */
#include "linear.h"

enum { LONG = 512 };

/*
 * Linear coordinates start anew from their planes: steps lose what a long run would show, half of
 * the last bit a pixel. Where 17 bits are a texel's fraction runs of LONG leave 2^-9 of it, others
 * start with every chunk.
 */
void qtri_linear_start(qtri_scanline *row, int32_t x)
{
    const qtri_job *job = row->job;
    for (int i = 0; i < 2; i++) {
        const uint64_t value =
            qtri_plane_column(row->by.plane[i], job->attribute[QTRI_U + i].plane.dx, x);
        row->curve[QTRI_U + i].at =
            qtri_run_scaled((uint32_t)qtri_plane_floor(value), job->axis[i].up);
    }
}

int32_t qtri_linear_texels(qtri_scanline *row, int32_t x)
{
    const int32_t from = (x - row->left) & (row->run_length - 1);
    if (!row->level) {
        qtri_linear_start(row, x - from);
    }
    for (int i = QTRI_U; i < QTRI_ATTRIBUTES; i++) {
        row->curve[i].at += (uint32_t)from * row->curve[i].step;
    }
    return row->level ? row->right : x - from + row->run_length;
}

void qtri_linear_row(qtri_scanline *row, int32_t x)
{
    const qtri_job *job = row->job;
    for (int i = job->first; i < QTRI_U; i++) {
        row->curve[i].at =
            qtri_ramp_at(&job->attribute[i].ramp, x - job->anchor_x, row->y - job->anchor_y);
    }
    if (job->end == QTRI_ATTRIBUTES) {
        (void)qtri_linear_texels(row, x);
    }
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
    row->run_length = LONG;
    for (int i = job->first; i < job->end; i++) {
        qtri_curve *curve = &row->curve[i];
        curve->bend = 0;
        curve->twist = 0;
        if (i < QTRI_U) {
            curve->step = job->attribute[i].ramp.dx;
        } else {
            const qtri_plane *plane = &job->attribute[i].plane;
            const qtri_texel_axis *axis = &job->axis[i - QTRI_U];
            row->by.plane[i - QTRI_U] =
                qtri_plane_row(plane, row->y) + ((uint64_t)axis->bias << 16);
            curve->step = plane_step(plane->dx, axis->up);
            row->run_length = axis->texel_shift < 17 ? QTRI_BATCH : row->run_length;
        }
    }
}
