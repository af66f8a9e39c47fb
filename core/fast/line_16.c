/* SPDX-License-Identifier: MIT */
/*
 * Short lines on pixels of 16 bits, without depth, or with depth "less" and written in surfaces
 * whose rows of pixels and of depths are equally far apart: most of a wireframe. The pixels are
 * those of raster/line.c.
 */
#include "line_16.h"

#include "../raster/line_path.h"

/*
 * The pixel to begin with. A pixel is as many bytes from its depth all over the surface: one
 * pointer walks both. Without depth it is the pixel's own.
 */
typedef struct walk_16 {
    uint8_t *at;
    uintptr_t apart;
    int32_t step, step_minor; /* bytes */
    int32_t rest, rest_step, denominator;
    uint32_t z_16p15, z_step;
} walk_16;

/* An integer, since no pointer may lead from one array to another. */
static inline uint16_t *pixel_of(const uint16_t *depth, uintptr_t apart)
{
    return (uint16_t *)((uintptr_t)depth + apart); /* NOLINT(performance-no-int-to-ptr) */
}

/* Draws `count` pixels. */
QTRI_INLINE void draw_pixels(walk_16 w, const uint16_t *tints, qtri_line_ramp share_q22,
                             int32_t count, bool has_depth)
{
    QTRI_HOLD(count);
    do {
        uint16_t *at = (uint16_t *)(void *)w.at;
        if (!has_depth) {
            *at = tints[share_q22.value >> QTRI_LINE_TINT_SHIFT];
        } else {
            const uint32_t z = w.z_16p15 >> 15;
            if (z < *at) {
                *at = (uint16_t)z;
                *pixel_of(at, w.apart) = tints[share_q22.value >> QTRI_LINE_TINT_SHIFT];
            }
            w.z_16p15 += w.z_step;
        }
        share_q22.value += share_q22.step;
        w.at += w.step;
        w.rest += w.rest_step;
        if (w.rest >= 0) {
            w.rest -= w.denominator;
            w.at += w.step_minor;
        }
    } while (--count != 0);
}

QTRI_INLINE void draw_short(const qtri_line_job *job, const qtri_vertex *a, const qtri_vertex *b,
                            const qtri_line_color *color, bool has_depth)
{
    qtri_line_path l;
    qtri_divider by;
    qtri_line_walk at;
    qtri_line_ramp share;
    walk_16 w;
    qtri_line_path_init(&l, a, b, 2, job->pitch);
    if (color != NULL || (uint32_t)(l.count - 1) >= QTRI_LINE_CHUNK) {
        qtri_line_draw(job, a, b, color);
        qtri_line_flush(job);
        return;
    }
    qtri_line_walk_short(&at, &l);
    int32_t end = l.count;
    if (!qtri_line_is_inside(job, a, b)) {
        const qtri_line_path path = l;
        qtri_line_walk first = at;
        end = qtri_line_cut_short(&first, job, &path);
        at = first;
        if (at.k >= end) {
            return;
        }
    }
    w.at = job->first + ((l.position + at.k) * l.step + at.minor * l.step_minor - job->origin);
    w.apart = job->apart;
    w.step = l.step + at.slope * l.step_minor;
    w.step_minor = l.step_minor;
    w.rest = at.rest;
    w.rest_step = at.rest_step;
    w.denominator = (int32_t)at.denominator;
    qtri_divider_init_short(&by, (uint32_t)l.length);
    w.z_16p15 = w.z_step = 0;
    if (has_depth) {
        qtri_line_ramp z;
        qtri_line_ramp_init(&z, qtri_line_depth_16p15(~0xFFu, l.first),
                            qtri_line_depth_16p15(~0xFFu, l.last), l.along, &by);
        w.z_16p15 = z.value + QTRI_LINE_DEPTH_HALF + (uint32_t)at.k * z.step;
        w.z_step = z.step;
    }
    qtri_line_ramp_share(&share, &l, &by);
    share.value += QTRI_LINE_TINT_HALF + (uint32_t)at.k * share.step;
    const uint16_t *table = qtri_batch_table(job->batch);
    if (has_depth) {
        draw_pixels(w, table, share, end - at.k, true);
    } else {
        draw_pixels(w, table, share, end - at.k, false);
    }
}

static void draw_less(const qtri_line_job *job, const qtri_vertex *a, const qtri_vertex *b,
                      const qtri_line_color *color)
{
    draw_short(job, a, b, color, true);
}

static void draw_over(const qtri_line_job *job, const qtri_vertex *a, const qtri_vertex *b,
                      const qtri_line_color *color)
{
    draw_short(job, a, b, color, false);
}

/* Either, where code is to be small. */
static void draw_shared(const qtri_line_job *job, const qtri_vertex *a, const qtri_vertex *b,
                        const qtri_line_color *color)
{
    draw_short(job, a, b, color, job->has_depth);
}

void qtri_line_16_choose(qtri_line_job *job)
{
    const qtri_surface *surface = job->surface;
    const ptrdiff_t pitch_end = (ptrdiff_t)1 << 16; /* times rows within 2^14 of 0: < 2^31 */
    const bool is_less =
        job->is_less && job->depth_write && surface->pitch == 2 * surface->depth_pitch;
    if (job->smooth != NULL || !job->batch->has_table ||
        surface->format->pixels->bytes != 2 || surface->pitch >= pitch_end ||
        surface->pitch <= -pitch_end || (job->has_depth && !is_less)) {
        return;
    }
    job->draw = QTRI_SHARE ? draw_shared : (job->has_depth ? draw_less : draw_over);
    job->first = job->has_depth ? (uint8_t *)surface->depth : surface->pixels;
    job->apart = (uintptr_t)surface->pixels - (uintptr_t)job->first;
    job->pitch = (int32_t)surface->pitch;
    job->origin = surface->first_row * job->pitch;
}
