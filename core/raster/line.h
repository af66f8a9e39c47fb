/* SPDX-License-Identifier: MIT */
/*
 * Lines of one draw call: what they share is prepared once. Internal.
 *
 * The ends of a line are vertices after the vertex stage. Of them count the place and the depth,
 * and the intensity of the light where lines are tinted.
 */
#ifndef QTRI_RASTER_LINE_H
#define QTRI_RASTER_LINE_H

#include "qtri/raster.h"
#include "qtri/view.h"

#include "stroke_span.h"

struct qtri_line_run;
struct qtri_stroke_line;

/* Colours of the two ends of a line, or of a chain of lines: red green blue, 0..255.0. */
typedef int32_t qtri_line_color[3];

typedef struct qtri_line_job qtri_line_job;

/*
 * Draws the line a b; the pixels of b a are the same. Its colours are color[0] at a and color[1] at
 * b; NULL: the material's, a and b being lit.
 */
typedef void (*qtri_line_draws)(const qtri_line_job *job, const qtri_vertex *a,
                                const qtri_vertex *b, const qtri_line_color *color);

/* Draws runs by the options of a job. */
typedef void (*qtri_line_runs)(const struct qtri_line_run *run);

/* A line of a job, as qtri_line_draws says, of runs. */
void qtri_line_draw(const qtri_line_job *job, const qtri_vertex *a, const qtri_vertex *b,
                    const qtri_line_color *color, qtri_line_runs draw);

struct qtri_line_job {
    qtri_line_draws draw;
    qtri_stroke_target *to;
    int32_t left_24p8, top_24p8;           /* of the bounds */
    uint32_t width_24p8, height_24p8;      /* 0, 0 when they are empty */
    uint32_t depth_mask;                   /* what of depth_16p8 is depth */
    int packing;                           /* of colours: one of QTRI_PACK_ONE, 565 and 888 */
    const struct qtri_stroke_line *smooth; /* what `draw` is stroke_line.c for */
    void *wide;                            /* and what it is stroke_mesh.c for */
};

/* `to` is initialised for lines of surface and material, and is there as long as the job. */
void qtri_line_job_init(qtri_line_job *job, const qtri_surface *surface,
                        const qtri_material *material, qtri_stroke_target *to);

/*
 * Whether lit lines take their colours from the state's table, which is there then: those of 565,
 * where light alone makes a pixel. They are off by 1/2 of a step for its rounding, by 63/256 for
 * light of 7 bits, and by 1/256 for light that lags.
 */
bool qtri_line_has_table(const qtri_line_job *job);

/* A vertex of any coordinates as an end, its depth within depth_16p8, and its colour. */
void qtri_line_end(qtri_vertex *end, qtri_line_color color, const qtri_screen_vertex *v);

/* Those of two ends in the material's colour, which are lit. */
void qtri_line_lit_colors(qtri_line_color color[2], const qtri_line_job *job, const qtri_vertex *a,
                          const qtri_vertex *b);

/* The look of a line from a to b as a part of a stroke; color: as qtri_line_draws has it. */
void qtri_line_look(qtri_stroke_look *look, const qtri_line_job *job, const qtri_vertex *a,
                    const qtri_vertex *b, const qtri_line_color *color);

/* Whether all of a triangle lies above or below the rows of this surface. */
static inline bool qtri_line_misses(const qtri_line_job *job, int32_t y0_24p8, int32_t y1_24p8,
                                    int32_t y2_24p8)
{
    const int32_t above = job->top_24p8;
    const int32_t below = above + (int32_t)job->height_24p8;
    return (y0_24p8 < above && y1_24p8 < above && y2_24p8 < above) ||
           (y0_24p8 >= below && y1_24p8 >= below && y2_24p8 >= below);
}

#endif
