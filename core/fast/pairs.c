/* SPDX-License-Identifier: MIT */
#include "pairs.h"

#include "../raster/texel_copy.h"
#include "smooth.h"

/*
 * A loop defines COLOR(name), a variable with the pixel's colour in the low half, and STEP(s),
 * which goes on to the next. SINGLE(s) draws a pixel and moves on; PAIR(i, s, t) draws pixels 2 i
 * and 2 i + 1, and after n of them comes MOVE(n).
 */
#define SINGLE(s)                                                                                  \
    if (qtri_passes(z >> 16, *depth, equal)) {                                                     \
        QTRI_BRANCH                                                                                \
        *depth = (uint16_t)(z >> 16);                                                              \
        COLOR(shown)                                                                               \
        *pixel = (uint16_t)shown;                                                                  \
    }                                                                                              \
    z += depth_step;                                                                               \
    STEP(s)                                                                                        \
    depth++;                                                                                       \
    pixel++;

#if QTRI_SELECT
#define PAIR(i, s, t)                                                                              \
    {                                                                                              \
        COLOR(first)                                                                               \
        STEP(s)                                                                                    \
        COLOR(second)                                                                              \
        STEP(t)                                                                                    \
        uint32_t next = z + depth_step;                                                            \
        uint32_t depths = qtri_pair_high(z, next);                                                 \
        z = next + depth_step;                                                                     \
        qtri_pair_select(&pixel, &depth, depths, qtri_pair_low(first, second), equal);             \
        QTRI_OPAQUE(z)                                                                             \
    }
#define MOVE(n)
#else
/* z / 2^16 < d, rounded down, is z < 2^16 d: the low half is compared where it is. */
#define PAIR(i, s, t)                                                                              \
    {                                                                                              \
        uint32_t stored = qtri_pair_load(depth + 2 * (i));                                         \
        if (equal ? z >> 16 <= (stored & 0xFFFF) : z < stored << 16) {                             \
            QTRI_BRANCH                                                                            \
            depth[2 * (i)] = (uint16_t)(z >> 16);                                                  \
            COLOR(shown)                                                                           \
            pixel[2 * (i)] = (uint16_t)shown;                                                      \
        }                                                                                          \
        z += depth_step;                                                                           \
        STEP(s)                                                                                    \
        uint32_t top = z >> 16;                                                                    \
        QTRI_OPAQUE(top)                                                                           \
        if (qtri_passes(top, stored >> 16, equal)) {                                               \
            QTRI_BRANCH                                                                            \
            depth[2 * (i) + 1] = (uint16_t)top;                                                    \
            COLOR(shown)                                                                           \
            pixel[2 * (i) + 1] = (uint16_t)shown;                                                  \
        }                                                                                          \
        z += depth_step;                                                                           \
        STEP(t)                                                                                    \
        QTRI_OPAQUE(z)                                                                             \
    }
#define MOVE(n) QTRI_MOVE(2 * (n))
#endif

/* `count` pixels: sixteen at a time, then two, then one. */
/* clang-format off */
#define PAIRS(count)                                                                               \
    for (const uint16_t *stop = depth + ((count) & ~15); depth != stop;) {                         \
        PAIR(0, , ) PAIR(1, , ) PAIR(2, , ) PAIR(3, , )                                            \
        PAIR(4, , ) PAIR(5, , ) PAIR(6, , ) PAIR(7, , )                                            \
        MOVE(8)                                                                                    \
    }                                                                                              \
    for (const uint16_t *stop = depth + ((count) & 14); depth != stop;) {                          \
        PAIR(0, , )                                                                                \
        MOVE(1)                                                                                    \
    }                                                                                              \
    if (((count) & 1) != 0) {                                                                      \
        SINGLE()                                                                                   \
    }
/* clang-format on */

enum { LONG = 12 }; /* pixels of one colour from which pairs are worth the while */

#define COLOR(name) const uint32_t name = color;
#define STEP(s)

QTRI_IN_PLACE void fill(const qtri_job *job, const qtri_span *spans, int32_t row, int32_t count,
                        bool equal)
{
    const qtri_raster *raster = job->raster;
    qtri_lines lines = qtri_lines_at(raster->surface, row);
    for (; count > 0; count--, spans++, row++) {
        int32_t x;
        int32_t rest = qtri_span_clip(spans, &raster->bounds, &x);
        if (rest > 0) {
            uint32_t z = qtri_ramp_at(&job->depth, x - job->anchor_x, row - job->anchor_y);
            uint16_t *pixel = (uint16_t *)(void *)lines.pixels + x;
            uint16_t *depth = lines.depths + x;
            const uint32_t depth_step = job->depth.dx;
            const uint32_t color = job->pixel;
            if (rest < LONG || !qtri_pairs_fit(pixel, depth)) {
                for (; rest > 0; rest--) {
                    SINGLE()
                }
            } else {
                if (!qtri_pair_begins(depth)) {
                    SINGLE()
                    rest--;
                }
                PAIRS(rest)
            }
        }
        lines.pixels += raster->surface->pitch;
        lines.depths += raster->surface->depth_pitch;
    }
}

#undef COLOR
#undef STEP
#define COLOR(name)                                                                                \
    uint32_t name = qtri_packed_pixel(packed);                                                     \
    QTRI_OPAQUE(name)
#define STEP(s)                                                                                    \
    packed += (s);                                                                                 \
    QTRI_OPAQUE(packed)

/* Pairs are those of a group of eight, or begin with its second pixel. */
QTRI_IN_PLACE void packed_row(qtri_packed_row *row, const qtri_job *job, bool equal)
{
    const uint32_t depth_step = job->depth.dx;
    const qtri_packed_steps *step = &job->color.step;
    uint16_t *pixel = row->pixel;
    uint16_t *depth = row->depth;
    if (!qtri_pairs_fit(pixel, depth)) {
        (equal ? qtri_packed_singly_equal : qtri_packed_singly)(row, job);
        return;
    }
    uint32_t z = row->z;
    uint32_t packed = row->packed;
    int32_t count = row->part;
    int32_t rest = row->rest;
    for (;;) {
        uint32_t one = step->even;
        uint32_t other = step->odd;
        uint32_t seventh = step->even;
        uint32_t eighth = step->last;
        if (!qtri_pair_begins(depth)) {
            SINGLE(one)
            one = other;
            other = seventh;
            seventh = eighth;
            eighth = other;
            count--;
        }
        for (const uint16_t *stop = depth + (count & ~7); depth != stop;) {
            PAIR(0, one, other)
            PAIR(1, one, other)
            PAIR(2, one, other)
            PAIR(3, seventh, eighth)
            MOVE(4)
        }
        if ((count & 7) != 0) {
            for (const uint16_t *stop = depth + (count & 6); depth != stop;) {
                PAIR(0, one, other)
                MOVE(1)
            }
            if ((count & 1) != 0) {
                SINGLE(one)
            }
        }
        if (rest <= 0) {
            return;
        }
        packed = qtri_packed_next(row, job);
        count = qtri_packed_part(rest);
        rest -= count;
    }
}

static void row_less(qtri_packed_row *row, const qtri_job *job)
{
    packed_row(row, job, false);
}

void qtri_smooth_pairs(const qtri_job *job, const qtri_span *spans, int32_t row, int32_t count)
{
    qtri_packed_rows(job, spans, row, count, row_less, false);
}

#undef COLOR
#undef STEP
#define COLOR(name)                                                                                \
    uint32_t name = texels[qtri_texel_index(u, v, cut)];                                           \
    QTRI_OPAQUE(name)
#define STEP(s)                                                                                    \
    u += u_step;                                                                                   \
    v += v_step;                                                                                   \
    QTRI_OPAQUE(u)                                                                                 \
    QTRI_OPAQUE(v)

QTRI_IN_PLACE void copy(const qtri_job *job, const qtri_run *run, bool equal)
{
    const qtri_raster *raster = job->raster;
    const uint16_t *texels = raster->texture->texels;
    const uint32_t cut = raster->texel_cut;
    uint16_t *pixel = (uint16_t *)(void *)run->pixels + run->x;
    uint16_t *depth = run->depths + run->x;
    uint32_t z = run->z;
    uint32_t u = run->value[0];
    uint32_t v = run->value[1];
    const uint32_t depth_step = job->depth.dx;
    const uint32_t u_step = run->step[0];
    const uint32_t v_step = run->step[1];
    int32_t count = run->count;
    if (!qtri_pairs_fit(pixel, depth)) {
        for (; count > 0; count--) {
            SINGLE()
        }
        return;
    }
    if (!qtri_pair_begins(depth)) {
        SINGLE()
        count--;
    }
    PAIRS(count)
}

void qtri_flat_pairs(const qtri_job *job, const qtri_span *spans, int32_t row, int32_t count)
{
    fill(job, spans, row, count, false);
}

void qtri_copy_pairs(const qtri_job *job, const qtri_run *run)
{
    copy(job, run, false);
}

#ifndef __OPTIMIZE_SIZE__
void qtri_flat_pairs_lequal(const qtri_job *job, const qtri_span *spans, int32_t row, int32_t count)
{
    fill(job, spans, row, count, true);
}

static void row_lequal(qtri_packed_row *row, const qtri_job *job)
{
    packed_row(row, job, true);
}

void qtri_smooth_pairs_lequal(const qtri_job *job, const qtri_span *spans, int32_t row,
                              int32_t count)
{
    qtri_packed_rows(job, spans, row, count, row_lequal, true);
}

void qtri_copy_pairs_lequal(const qtri_job *job, const qtri_run *run)
{
    copy(job, run, true);
}
#endif
