/* SPDX-License-Identifier: MIT */
#include "smooth.h"

#include "fused.h"
#include "pairs.h"

/* `count` pixels, the first of which is pixel `phase` of a group. */
static void draw(qtri_packed_row *row, const qtri_job *job, int32_t phase, int32_t count,
                 bool equal)
{
    const qtri_packed_steps *step = &job->color.step;
    for (; count > 0; count--, phase++) {
        if (qtri_passes(row->z >> 16, *row->depth, equal)) {
            *row->depth = (uint16_t)(row->z >> 16);
            *row->pixel = (uint16_t)qtri_packed_pixel(row->packed);
        }
        row->z += job->depth.dx;
        row->packed += phase % 8 == 7 ? step->last : (phase % 2 == 0 ? step->even : step->odd);
        row->depth++;
        row->pixel++;
    }
}

static bool next_run(qtri_packed_row *row, const qtri_job *job)
{
    if (row->rest <= 0) {
        return false;
    }
    row->packed = qtri_packed_next(row, job);
    row->part = qtri_packed_part(row->rest);
    row->rest -= row->part;
    return true;
}

bool qtri_packed_cut(qtri_packed_row *row, const qtri_job *job, int32_t skip, bool equal)
{
    const int32_t to_group = -skip & 7;
    const int32_t count = to_group < row->part ? to_group : row->part;
    row->packed += qtri_packed_skip(job, skip);
    draw(row, job, skip, count, equal);
    row->part -= count;
    return row->part > 0 || next_run(row, job);
}

#if QTRI_PAIRS

/* Small code: where there are pairs, few surfaces need it. */
static void singly(qtri_packed_row *row, const qtri_job *job, bool equal)
{
    do {
        draw(row, job, 0, row->part, equal);
    } while (next_run(row, job));
}

#else

#define PIXEL(i, step)                                                                             \
    if (qtri_passes(z >> 16, depth[i], equal)) {                                                   \
        QTRI_BRANCH                                                                                \
        depth[i] = (uint16_t)(z >> 16);                                                            \
        pixel[i] = (uint16_t)qtri_packed_pixel(packed);                                            \
    }                                                                                              \
    z += depth_step;                                                                               \
    packed += (step);                                                                              \
    QTRI_OPAQUE(z)                                                                                 \
    QTRI_OPAQUE(packed)                                                                            \
    QTRI_ASIDE(depth_step)                                                                         \
    QTRI_ASIDE(even)                                                                               \
    QTRI_ASIDE(odd)

QTRI_IN_PLACE void singly(qtri_packed_row *row, const qtri_job *job, bool equal)
{
    uint32_t depth_step = job->depth.dx;
    uint32_t even = job->color.step.even;
    uint32_t odd = job->color.step.odd;
    const uint32_t last = job->color.step.last;
    uint16_t *pixel = row->pixel;
    uint16_t *depth = row->depth;
    uint32_t z = row->z;
    uint32_t packed = row->packed;
    int32_t count = row->part;
    int32_t rest = row->rest;
    for (;;) {
        if (count >= 8) {
            const uint16_t *stop = depth + (count & ~7);
            do {
                PIXEL(0, even)
                PIXEL(1, odd)
                PIXEL(2, even)
                PIXEL(3, odd)
                PIXEL(4, even)
                PIXEL(5, odd)
                PIXEL(6, even)
                PIXEL(7, last)
                QTRI_MOVE(8)
            } while (depth != stop);
        }
        if ((count & 4) != 0) {
            PIXEL(0, even)
            PIXEL(1, odd)
            PIXEL(2, even)
            PIXEL(3, odd)
            depth += 4;
            pixel += 4;
        }
        if ((count & 2) != 0) {
            PIXEL(0, even)
            PIXEL(1, odd)
            depth += 2;
            pixel += 2;
        }
        if ((count & 1) != 0) {
            PIXEL(0, even)
            depth++;
            pixel++;
        }
        if (rest <= 0) {
            return;
        }
        packed = qtri_packed_next(row, job);
        count = qtri_packed_part(rest);
        rest -= count;
    }
}

#endif

void qtri_packed_singly(qtri_packed_row *row, const qtri_job *job)
{
    singly(row, job, false);
}

void qtri_smooth_less(const qtri_job *job, const qtri_span *spans, int32_t row, int32_t count)
{
    qtri_packed_rows(job, spans, row, count, qtri_packed_singly, false);
}

#ifndef __OPTIMIZE_SIZE__
void qtri_packed_singly_equal(qtri_packed_row *row, const qtri_job *job)
{
    singly(row, job, true);
}

void qtri_smooth_lequal(const qtri_job *job, const qtri_span *spans, int32_t row, int32_t count)
{
    qtri_packed_rows(job, spans, row, count, qtri_packed_singly_equal, true);
}
#endif
