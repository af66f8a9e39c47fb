/* SPDX-License-Identifier: MIT */
/*
 * Lines of one draw call, which share a job. Internal.
 *
 * The ends of a line are vertices after the vertex stage, of which position, depth and, without
 * colours, the intensity of light are read.
 */
#ifndef QTRI_RASTER_LINE_H
#define QTRI_RASTER_LINE_H

#include "qtri/draw.h"
#include "qtri/view.h"

#include "stroke_pixels.h"

struct qtri_line_run;

/* The colour of an end of a line: red green blue, 8.16, 0..255.0. */
typedef int32_t qtri_line_color[3];

typedef struct qtri_line_job qtri_line_job;

/*
 * Draws the line a b; the pixels of b a are the same. Its colours are color[0] at a and color[1] at
 * b; NULL: the material's, a and b being lit.
 */
typedef void (*qtri_line_draws)(const qtri_line_job *job, const qtri_vertex *a,
                                const qtri_vertex *b, const qtri_line_color *color);

/*
 * Smooth lines of up to two pixels, one by one.
 *
 * A line is the rectangle of its width that ends flat, at its ends or half a width beyond. It is
 * walked column by column along its longer axis, with the exact area of each pixel that it covers,
 * to the rounding of its corners to 1/256: no list of parts, no window, no root a row, as unions of
 * shapes need them (stroke.h). So it costs a fraction of that, and overlaps are blended twice.
 */
typedef struct qtri_stroke_line {
    int32_t radius_24p8; /* 1..QTRI_STROKE_LINE_RADIUS */
    bool square;         /* ends reach a radius further */
    uint8_t alpha;
} qtri_stroke_line;

#define QTRI_STROKE_LINE_RADIUS 256 /* 24.8: two pixels of width */

/* Draws the pixels of a run, by the options of a pipeline. */
typedef void (*qtri_line_runs)(const struct qtri_line_run *run);

/* A qtri_line_draws but for `draw`: cuts the line into runs, which `draw` draws. */
void qtri_line_draw(const qtri_line_job *job, const qtri_vertex *a, const qtri_vertex *b,
                    const qtri_line_color *color, qtri_line_runs draw);

struct qtri_line_job {
    qtri_line_draws draw;
    qtri_stroke_target *to;
    int32_t left_24p8, top_24p8;              /* the bounds of the surface */
    uint32_t width_24p8, height_24p8;         /* 0, 0 when they are empty */
    uint32_t depth_mask;                      /* the bits of depth_16p8 that are depth */
    const struct qtri_large_packing *packing; /* which channels are stepped */
    const qtri_stroke_line *smooth;           /* set if `draw` is in stroke_line.c */
    void *wide;                               /* set if `draw` is in strokes.c */
};

/* Initialises job and `to`, which the job needs as long as it lives. */
void qtri_line_job_init(qtri_line_job *job, const qtri_surface *surface,
                        const qtri_material *material, qtri_stroke_target *to);

/*
 * Whether lit lines take their colours from the state's table, which is there then: those of 565,
 * where light alone makes a pixel. They are off by 1/2 of a step for its rounding, by 63/256 for
 * light of 7 bits, and by 1/256 for light that lags.
 */
bool qtri_line_has_table(const qtri_line_job *job);

/* Sets an end and its colour from a vertex of any coordinates, clamped. */
void qtri_line_end(qtri_vertex *end, qtri_line_color color, const qtri_screen_vertex *v);

/* A colour in a light of 0..2^15. */
static inline void qtri_line_color_set(qtri_line_color out, const qtri_rgb *rgb, uint32_t light_q15)
{
    const int32_t light = (int32_t)light_q15 * 2;
    out[0] = rgb->r * light; /* <= 255.0 */
    out[1] = rgb->g * light;
    out[2] = rgb->b * light;
}

/* The look of a line from a to b as a part of a stroke; color: as qtri_line_draws has it, or, where
   they are turned, of the line from b to a. */
void qtri_line_look(qtri_stroke_look *look, const qtri_line_job *job, const qtri_vertex *a,
                    const qtri_vertex *b, const qtri_line_color *color, bool turned);

/* Whether all of a triangle lies above or below the rows of this surface. */
static inline bool qtri_line_misses(const qtri_line_job *job, int32_t y0_24p8, int32_t y1_24p8,
                                    int32_t y2_24p8)
{
    const int32_t above = job->top_24p8, below = above + (int32_t)job->height_24p8;
    return (y0_24p8 < above && y1_24p8 < above && y2_24p8 < above) ||
           (y0_24p8 >= below && y1_24p8 >= below && y2_24p8 >= below);
}

/* How far smooth lines reach beyond their ends: corners sqrt(2) radii. */
#define QTRI_STROKE_LINE_REACH 512 /* 24.8 */

/* Makes a job of surface and material draw smooth lines of a style. As their corners lie beyond the
   vertices, qtri_line_misses() then looks at more rows than the surface has. */
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
