/* SPDX-License-Identifier: MIT */
/*
 * Lines of one draw call: what they share is prepared once. Internal.
 *
 * The ends of a line are vertices after the vertex stage. Of them count the place and the depth,
 * and the intensity of the light where lines are tinted.
 */
#ifndef QTRI_RASTER_LINE_H
#define QTRI_RASTER_LINE_H

#include <stdbool.h>

#include "qtri/raster.h"
#include "qtri/view.h"

#include "batch.h"
#include "stroke_span.h"

struct qtri_stroke_line;

/* Colours of the two ends of a line, or of a chain of lines: red green blue, 0..255.0. */
typedef int32_t qtri_line_color[3];

typedef struct qtri_line_job qtri_line_job;

/* */
typedef void (*qtri_line_effect)(const qtri_line_job *job, const qtri_ramp *depth);

/*
 * Draws the line a b; the pixels of b a are the same. Its colours are color[0] at a and color[1] at
 * b; NULL: shares of the tint, a and b being lit.
 */
typedef void (*qtri_line_draws)(const qtri_line_job *job, const qtri_vertex *a,
                                const qtri_vertex *b, const qtri_line_color *color);

/*
 * What the batch holds: pixels that have passed, whose depths are written, and that are to be
 * stored together and in their order. Their colours are shares of the tint in Q22, or colour words.
 *
 * Shares are rounded to the bits that are enough for the format's colours: 565 is then off by
 * 63/256 of a step, by 1/256 from lines that lag and the tint, and by the 1/2 of its own rounding,
 * 3/4 in all; 8 bits a channel are within 5/8 and 1/64. The 129 shares of 565 fit a table.
 */
enum { QTRI_LINE_SHARES, QTRI_LINE_WORDS };

struct qtri_line_job {
    const qtri_surface *surface;
    qtri_line_draws draw; /* any line, as fast as it can be */
    qtri_batch *batch;
    int32_t left_24p8, top_24p8;      /* of the bounds */
    uint32_t width_24p8, height_24p8; /* 0, 0 when they are empty */
    uint32_t first_place;             /* of the surface in the frame */
    uint32_t depth_mask;              /* what of depth_16p8 is depth */
    uint32_t less, passing;           /* depths that pass: see line.c */
    bool has_depth, depth_write, is_less;
    bool writes_early;                    /* depth as soon as it is compared */
    qtri_line_effect effect;              /* of fog and a blend; NULL: neither */
    const struct qtri_depth_ops *testing; /* depths that `effect` tests, has_depth being false */
    const qtri_material *material;        /* theirs */
    uint32_t tint_n8[3]; /* channels of the tint, in steps; of one that is single the last */
    const struct qtri_stroke_line *smooth; /* what draws them is stroke_line.c; NULL: it is not */
    struct qtri_stroke_target *smooth_target; /* and where it draws them to */
    /* For fast/line_16.c: the first depth, or the first pixel where there are none; bytes from the
       one to the other, from row to row, and from the frame to the surface. */
    uint8_t *first;
    uintptr_t apart;
    int32_t pitch, origin;
};

/* Tinted by the material's colour. `batch` and the material are there as long as the job. */
void qtri_line_job_init(qtri_line_job *job, const qtri_surface *surface,
                        const qtri_material *material, qtri_batch *batch);

/*
 * Makes colour words of `count` shares of the tint in Q22. Times a tint of at most 255.0 they are
 * below 2^26.
 */
void qtri_line_tint(uint32_t *color, const qtri_line_job *job, int32_t count);

/* Makes a table of tints if there can be one: the same pixels, sooner where there are many. */
void qtri_line_make_table(const qtri_line_job *job);

/* A vertex of any coordinates as an end, its depth within depth_16p8, and its colour. */
void qtri_line_end(qtri_vertex *end, qtri_line_color color, const qtri_screen_vertex *v);

/* A qtri_line_draws for every job, into its batch; stores what is in it. */
void qtri_line_draw(const qtri_line_job *job, const qtri_vertex *a, const qtri_vertex *b,
                    const qtri_line_color *color);
void qtri_line_flush(const qtri_line_job *job);

/* The same for jobs with an effect: what is in the batch lies on different pixels, and in one
 * chunk. */
void qtri_line_draw_apart(const qtri_line_job *job, const qtri_vertex *a, const qtri_vertex *b,
                          const qtri_line_color *color);

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
