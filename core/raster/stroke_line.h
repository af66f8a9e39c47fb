/* SPDX-License-Identifier: MIT */
/*
 * Smooth lines of up to two pixels, one by one. Internal.
 *
 * A line is the rectangle of its width that ends flat, at its ends or half a width beyond. It is
 * walked column by column along its longer axis, with the exact area of each pixel that it covers,
 * to the rounding of its corners to 1/256: no list of parts, no window, no root a row, as unions of
 * shapes need them (stroke.h). So it costs a fraction of that, and overlaps are blended twice.
 */
#ifndef QTRI_RASTER_STROKE_LINE_H
#define QTRI_RASTER_STROKE_LINE_H

#include "line.h"
#include "stroke_span.h"

#define QTRI_STROKE_LINE_RADIUS 256 /* 24.8: two pixels of width */

typedef struct qtri_stroke_line {
    int32_t radius_24p8; /* 1..QTRI_STROKE_LINE_RADIUS */
    bool square;         /* ends reach a radius further */
    uint8_t alpha;
} qtri_stroke_line;

/* A corner lies at most sqrt(2) radii from an end. */
#define QTRI_STROKE_LINE_REACH 512 /* 24.8 */

/*
 * Lets the job, of surface and material, draw smooth lines. The rows in which it looks for
 * triangles reach further then than those of the surface, which stroke_line.c knows.
 */
static inline void qtri_stroke_line_choose(qtri_line_job *job, const qtri_surface *surface,
                                           const qtri_material *material,
                                           const qtri_stroke_line *style, qtri_line_draws draw)
{
    job->smooth = style;
    job->draw = draw;
    job->top_24p8 -= QTRI_STROKE_LINE_REACH;
    job->height_24p8 += 2 * QTRI_STROKE_LINE_REACH;
    if (!qtri_stroke_target_init(job->to, surface, material, qtri_stroke_pipelines, style->alpha,
                                 true)) {
        job->width_24p8 = 0;
    }
}

/* A qtri_line_draws for jobs whose `smooth` is set. What is drawn is stored at once. */
void qtri_stroke_line_draw(const qtri_line_job *job, const qtri_vertex *a, const qtri_vertex *b,
                           const qtri_line_color *color);

#endif
