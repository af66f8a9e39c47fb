/*
 * Spans: the pixels of a triangle in one row, with everything about the triangle that they need.
 * Internal.
 *
 * A span is drawn as runs: stretches over which every attribute is a 32-bit ramp. Without
 * perspective a span is one run; with it, a run goes from one exact division to the next. Which
 * loop draws the runs is chosen once a triangle. qtri_run_generic draws all; the loops for what
 * matters most are made from run_loops.inc and give its pixels to the bit.
 */
#ifndef QTRI_RASTER_SPAN_H
#define QTRI_RASTER_SPAN_H

#include <stdbool.h>

#include "qtri/material.h"

#include "pixel.h"
#include "plane.h"
#include "texel.h"

/* Where colour and texture coordinates come from. */
typedef enum qtri_paint {
    QTRI_PAINT_FLAT,       /* one pixel value */
    QTRI_PAINT_LINEAR,     /* ramps of colours, planes of texture coordinates */
    QTRI_PAINT_PERSPECTIVE /* planes of attribute / w, and of 1 / w */
} qtri_paint;

enum { QTRI_ATTRIBUTES = 5 }; /* red green blue u v */

typedef struct qtri_span_job qtri_span_job;

/* Pixels x .. x+count-1 of a row; all values at the first, with what rounds them added. */
typedef struct qtri_run {
    uint8_t *pixels; /* of the whole row */
    uint16_t *depths;
    int32_t x, count;
    uint32_t z;                       /* 16.16 */
    uint32_t color[3], color_step[3]; /* n.16 */
    uint32_t uv[2], uv_step[2];       /* as qtri_texel_axis */
} qtri_run;

typedef void (*qtri_run_loop)(const qtri_span_job *job, const qtri_run *run);

struct qtri_span_job {
    const qtri_surface *surface;
    const qtri_texture *texture; /* NULL: none */
    qtri_run_loop loop;
    qtri_compare compare; /* QTRI_DEPTH_OFF: depth neither read nor written */
    bool depth_write;
    bool smooth; /* colours vary: ramps or planes 0..2 are set */
    qtri_paint paint;
    uint32_t pixel;                        /* FLAT */
    qtri_channels color;                   /* when not smooth */
    int32_t anchor_x, anchor_y;            /* origin of the ramps: a pixel of the frame */
    qtri_ramp depth;                       /* 16.16 */
    qtri_ramp ramp[3];                     /* LINEAR and smooth */
    qtri_plane attribute[QTRI_ATTRIBUTES]; /* PERSPECTIVE: units 2^n inv_w / 2^31; LINEAR: u, v */
    qtri_plane inv_w;                      /* PERSPECTIVE: 2^31 for the vertex nearest to the eye */
    int32_t least[3], greatest[3];         /* of the vertices' colours, n.16: PERSPECTIVE clamps */
    qtri_texel_axis axis[2];
};

/* PERSPECTIVE: colours (n.16, up to 24 bits) are scaled by this much to use 30 bits. */
#define QTRI_COLOR_PERSPECTIVE_SHIFT 6

/*
 * Draws the pixels of row y that lie in x0..x1-1, which the caller has held inside the surface's
 * bounds, of a span that covers left..right-1. Where the exact divisions fall depends on left and
 * right alone, so that a scissor does not change a pixel.
 */
void qtri_span(const qtri_span_job *job, int32_t y, int32_t left, int32_t right, int32_t x0,
               int32_t x1);

void qtri_run_generic(const qtri_span_job *job, const qtri_run *run);

/* The fastest loop that draws this job's runs. */
qtri_run_loop qtri_run_choose(const qtri_span_job *job);

/* Whether a fragment at depth z passes against the stored depth. */
static inline bool qtri_depth_passes(qtri_compare compare, uint32_t z, uint32_t stored)
{
    switch (compare) {
    case QTRI_NEVER:
        return false;
    case QTRI_LESS:
        return z < stored;
    case QTRI_EQUAL:
        return z == stored;
    case QTRI_LESS_EQUAL:
        return z <= stored;
    case QTRI_GREATER:
        return z > stored;
    case QTRI_NOT_EQUAL:
        return z != stored;
    case QTRI_GREATER_EQUAL:
        return z >= stored;
    default:
        return true;
    }
}

#endif
