/* SPDX-License-Identifier: MIT */
/*
 * Strokes: the union of the shapes of a line's parts. Internal.
 *
 * A part, the segment from a to b, is a convex shape: a rectangle and, at joints and round ends, a
 * disc. Pixels are found in strips of 32 columns, row by row. With hard edges a row is what the
 * parts' shapes cover of the level through its pixels' centres. With smooth ones it is cut into
 * slices in which all bounds are straight, and the parts of a slice that overlap are one. What a
 * pixel becomes depends on the parts alone, never on what a band or a scissor leaves of them.
 */
#ifndef QTRI_RASTER_STROKE_H
#define QTRI_RASTER_STROKE_H

#include "qtri/stroke.h"

#include "../bits/bits.h"
#include "../paint/coverage.h"
#include "line.h"
#include "stroke_shape.h"

enum {
    QTRI_STROKE_SHAPES = 6, /* in the cache */
    QTRI_STROKE_NEAR = 24,  /* parts of a strip that are listed */
    QTRI_STROKE_BLOCKS = 8  /* groups of consecutive parts, with a box each */
};

/* Finds the ends of part `part` and, if `end` is not NULL, their depth and colour; false: it is
   clipped away. */
typedef bool (*qtri_stroke_source)(const void *from, uint32_t part, qtri_point at[2],
                                   qtri_stroke_end end[2]);

/* Pixels: x0 <= x < x1. */
typedef struct qtri_stroke_box {
    int16_t x0, y0, x1, y1;
} qtri_stroke_box;

/* A part that overlaps the strip, and the box of its pixels. */
typedef struct qtri_stroke_near {
    uint32_t part;
    qtri_stroke_box box;
} qtri_stroke_near;

/* Up to 32 columns of a row, with the shapes that cover them. */
typedef struct qtri_stroke_window {
    qtri_coverage coverage; /* its columns; all sums are 0 between rows */
    int32_t row;
    int32_t first, end; /* columns of the window that are covered, from 0 */
    uint32_t shared;    /* a bit for each column that several parts touch, where looks differ, */
    uint32_t part[QTRI_COVERAGE_WINDOW]; /* and whose colours they have */
    qtri_stroke_shape *shape[QTRI_STROKE_SHAPES];
    uint32_t shape_count;
    bool is_complete; /* all shapes of the row are in `shape`; else none is */
    int32_t same_end; /* they are those of all rows before this one, too */
} qtri_stroke_window;

/* Constants of points of one radius; see stroke_point.c. */
typedef struct qtri_stroke_disc {
    uint16_t radius;      /* 24.8; 0: not set */
    uint16_t down;        /* 2^-down: from the square times 2^-16 to an area */
    uint32_t inverse_q30; /* of the radius: 2^30 / radius */
    uint32_t square;      /* of the radius, with 16 bits */
    int32_t area;         /* of a quarter of the disc */
} qtri_stroke_disc;

#define QTRI_STROKE_POINT_RADIUS 4096 /* 24.8: of points that are drawn without a union */

/* A block of pixels; x, y: its left upper corner less the point's centre, 24.8. */
typedef struct qtri_stroke_block {
    int32_t x, y, count, rows;
    int32_t radius;
    bool is_round;
} qtri_stroke_block;

typedef struct qtri_stroker {
    const qtri_stroke_edges *edges;
    qtri_stroke_source source;
    const void *from;
    uint32_t count; /* of its parts */
    qtri_stroke_target to;
    int32_t radius;
    uint8_t cap;
    bool closed, has_one_look;
    qtri_stroke_look look; /* of all parts, or of the one that is drawn */
    qtri_stroke_ring ring; /* of smooth edges */
    qtri_stroke_disc disc;
    qtri_stroke_shape shape[QTRI_STROKE_SHAPES];
    uint32_t next_shape; /* the one to be replaced where all are in use */
    qtri_stroke_near near[QTRI_STROKE_NEAR];
    uint32_t near_count;
    uint32_t others; /* the first part that was not listed, for lack of room, or QTRI_STROKE_NONE */
    qtri_stroke_box block[QTRI_STROKE_BLOCKS];
    uint32_t block_parts; /* parts in a block */
    qtri_stroke_window window;
} qtri_stroker;

/* The functions of smooth edges; hard ones have none. */
struct qtri_stroke_edges {
    void (*set_ring)(qtri_stroke_ring *ring, int32_t radius);
    /* Adds what the row's shapes cover together to the window. */
    void (*cover)(qtri_stroker *stroker);
    /* Weights of a block of a point, row by row. `disc` is kept for points of its radius. */
    void (*cover_point)(qtri_stroke_disc *disc, const qtri_stroke_block *block, uint32_t alpha_q16,
                        uint16_t *weight);
    qtri_line_draws line; /* thin ones, each by itself: see line.h */
};

/* False: nothing can be drawn. `in_space`: each point has a radius of its own. */
bool qtri_stroker_init(qtri_stroker *stroker, const qtri_surface *surface,
                       const qtri_material *material, const qtri_stroke *stroke, bool in_space);

/* Draws the line through `points` points, at least one. */
void qtri_stroker_draw(qtri_stroker *stroker, qtri_stroke_source source, const void *from,
                       uint32_t points, bool closed);

/* Draws one part by itself, with stroker->look. */
void qtri_stroker_draw_part(qtri_stroker *stroker, const qtri_stroke_place *place);

/* stroke_point.c: a disc or a square of at most QTRI_STROKE_POINT_RADIUS, with stroker->look. */
void qtri_stroker_draw_point(qtri_stroker *stroker, const qtri_point *center, int32_t radius,
                             bool is_round);
void qtri_stroke_point_cover(qtri_stroke_disc *disc, const qtri_stroke_block *block,
                             uint32_t alpha_q16, uint16_t *weight);

#define QTRI_STROKE_NONE UINT32_MAX

/* The shape of the row's next part from `part` on, where there is no room for all; NULL: none. */
qtri_stroke_shape *qtri_stroker_find_next(qtri_stroker *stroker, uint32_t part);

/* Iterates over shapes of the row: the one after `shape`, NULL at first, or NULL. *count is 0 at
   first. Each is valid until the next call. */
static inline qtri_stroke_shape *qtri_stroker_next(qtri_stroker *stroker,
                                                   const qtri_stroke_shape *shape, uint32_t *count)
{
    const qtri_stroke_window *w = &stroker->window;
    if (*count < w->shape_count) {
        return w->shape[(*count)++];
    }
    return w->is_complete ? NULL
                          : qtri_stroker_find_next(stroker, shape != NULL ? shape->part + 1 : 0);
}

/* Adds columns of the window that lie from x0 to x1 to those that are covered. */
static inline void qtri_stroke_window_add(qtri_stroke_window *w, int32_t x0, int32_t x1)
{
    const int32_t first = (x0 >> 8) - w->coverage.x, end = ((x1 + 255) >> 8) - w->coverage.x;
    w->first = qtri_least32(w->first, qtri_greatest32(first, 0));
    w->end = qtri_greatest32(w->end, qtri_least32(end, w->coverage.end - w->coverage.x));
}

#endif
