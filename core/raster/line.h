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

typedef struct qtri_line_job {
    const qtri_surface *surface;
    int32_t left_24p8, top_24p8;      /* of the bounds */
    uint32_t width_24p8, height_24p8; /* 0, 0 when they are empty */
    int32_t pitch, origin;            /* bytes from row to row, and from the frame to the surface */
    int32_t fast_24p8;                /* shorter lines take the fast path */
    uint32_t depth_mask;              /* what of depth_16p8 is depth */
    qtri_compare compare;             /* QTRI_DEPTH_OFF: depth neither read nor written */
    bool depth_write;
    qtri_rgb tint;
} qtri_line_job;

/* Colours of the two ends of a line, or of a chain of lines: red green blue, 0..255.0. */
typedef int32_t qtri_line_color[3];

void qtri_line_job_init(qtri_line_job *job, const qtri_surface *surface,
                        const qtri_material *material);

/* A vertex of any coordinates as an end, its depth within depth_16p8, and its colour. */
void qtri_line_end(qtri_vertex *end, qtri_line_color color, const qtri_screen_vertex *v);

/*
 * Draws the line a b; the pixels of b a are the same. Its colours are color[0] at a and color[1] at
 * b; NULL: shares of the tint, a and b being lit.
 */
void qtri_line_draw(const qtri_line_job *job, const qtri_vertex *a, const qtri_vertex *b,
                    const qtri_line_color *color);

/*
 * Whether a line drawn again has no effect, whatever colours it has then and whatever was drawn in
 * between: depths that are stored only get nearer (or only farther), and equal ones fail.
 */
static inline bool qtri_line_is_final(qtri_compare compare, bool depth_write)
{
    return depth_write && (compare == QTRI_LESS || compare == QTRI_GREATER);
}

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
