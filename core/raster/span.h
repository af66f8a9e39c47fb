/*
 * Spans: runs of pixels in one row, with everything about a triangle that they need. Internal.
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
    QTRI_PAINT_LINEAR,     /* planes of the attributes */
    QTRI_PAINT_PERSPECTIVE /* planes of attribute / w, and of 1 / w */
} qtri_paint;

enum { QTRI_ATTRIBUTES = 5 }; /* red green blue u v */

typedef struct qtri_span_job {
    const qtri_surface *surface;
    const qtri_texture *texture; /* NULL: none */
    qtri_compare compare;        /* QTRI_DEPTH_OFF: depth neither read nor written */
    bool depth_write;
    qtri_paint paint;
    bool smooth;                   /* colours vary: planes 0..2 are set */
    uint32_t pixel;                /* FLAT */
    qtri_channels color;           /* when not smooth */
    int32_t least[3], greatest[3]; /* of the vertices' colours, n.16: PERSPECTIVE clamps */
    qtri_texel_axis axis[2];
    qtri_plane depth;                      /* 16.16 */
    qtri_plane inv_w;                      /* PERSPECTIVE: 2^31 for the vertex nearest to the eye */
    qtri_plane attribute[QTRI_ATTRIBUTES]; /* LINEAR: units; PERSPECTIVE: units 2^n inv_w / 2^31 */
} qtri_span_job;

/* PERSPECTIVE: colours (n.16, up to 24 bits) are scaled by this much to use 30 bits. */
#define QTRI_COLOR_PERSPECTIVE_SHIFT 6

/* Draws pixels x0..x1-1 of row y; the caller has held them inside the surface's bounds. */
void qtri_span(const qtri_span_job *job, int32_t y, int32_t x0, int32_t x1);

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
