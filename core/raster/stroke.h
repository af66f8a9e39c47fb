/* SPDX-License-Identifier: MIT */
/*
 * Strokes: the union of the shapes of a line's parts. Internal.
 *
 * A part, the segment from a to b, is a convex shape: a rectangle and, at joints and round ends, a
 * disc. Pixels are found in strips of 32 columns, row by row: each part of a row adds what it
 * covers, and a pixel that several cover in part takes the area of their union. What a pixel
 * becomes depends on the parts alone, never on what a band or a scissor leaves of them.
 */
#ifndef QTRI_RASTER_STROKE_H
#define QTRI_RASTER_STROKE_H

#include "qtri/stroke.h"

#include "../bits/bits.h"
#include "../paint/coverage.h"
#include "line.h"
#include "stroke_shape.h"

enum {
    QTRI_STROKE_SHAPES = 6, /* kept */
    QTRI_STROKE_NEAR = 24,  /* parts of a strip that are listed */
    QTRI_STROKE_RING = 19,
    QTRI_STROKE_BLOCKS = 16 /* of parts that follow each other, with their boxes */
};

/* Parts 0 .. count-1. `place` says false of what is not to be seen. */
typedef struct qtri_stroke_source {
    const void *from;
    uint32_t count;
    bool (*place)(const void *from, uint32_t part, qtri_stroke_place *place);
    void (*ends)(const void *from, uint32_t part, qtri_stroke_end end[2]);
} qtri_stroke_source;

/* Pixels: x0 <= x < x1. */
typedef struct qtri_stroke_box {
    int16_t x0, y0, x1, y1;
} qtri_stroke_box;

/* A part that meets the strip: rows that it may touch, and columns of the window in the last row.
 */
typedef struct qtri_stroke_near {
    uint32_t part;
    int16_t y0, y1;
    uint8_t first, end;
} qtri_stroke_near;

/* Half of a polygon around a disc, from its top down, by what small round points are drawn. */
typedef struct qtri_stroke_ring {
    int32_t radius;
    int32_t count;
    struct {
        int32_t y, half;     /* from the centre */
        int32_t slope_q16;   /* of half, from here to the next */
        int32_t inverse_q16; /* 1 / |slope| */
    } at[QTRI_STROKE_RING];
} qtri_stroke_ring;

/* Columns of a row. */
typedef struct qtri_stroke_window {
    qtri_coverage coverage; /* its columns; all sums are 0 between parts */
    int32_t row;
    int32_t first, end; /* columns of the window that parts touch, from 0 */
    uint32_t in_part;   /* a bit for each column that several parts cover, none of them all */
    uint32_t shared;    /* and for each that several parts touch */
    int32_t cover[QTRI_COVERAGE_WINDOW]; /* at most QTRI_COVERAGE_FULL; between rows 0 */
    uint32_t part[QTRI_COVERAGE_WINDOW]; /* whose colours they have, where looks differ */
} qtri_stroke_window;

typedef struct qtri_stroker {
    const qtri_stroke_source *source;
    const qtri_stroke_edges *edges;
    qtri_stroke_target to;
    qtri_stroke_look look; /* of all parts, or of the one that is drawn */
    bool has_one_look;
    qtri_stroke_shape shape[QTRI_STROKE_SHAPES];
    uint32_t next_shape;    /* the one to be replaced where all are in use */
    qtri_stroke_shape disc; /* of the last shape that has one apart, */
    uint32_t apart;         /* which is this part's */
    union {
        struct {
            qtri_stroke_near near[QTRI_STROKE_NEAR];
            uint8_t active[QTRI_STROKE_NEAR]; /* those of them that touch the row's window */
        } parts;
        qtri_stroke_ring ring; /* while points are drawn that are small discs */
    } of;
    bool has_ring;
    uint32_t near_count;
    uint32_t active_count;
    uint32_t others; /* from this part on there may be more of them; UINT32_MAX: none */
    qtri_stroke_box block[QTRI_STROKE_BLOCKS];
    uint32_t block_parts; /* of one */
    qtri_stroke_window window;
} qtri_stroker;

struct qtri_stroke_edges {
    /* Sets what of a row lies inside; adds it to `coverage` where that is not NULL. */
    void (*find_row)(qtri_stroke_shape *shape, int32_t row, qtri_coverage *coverage);
    /* Adds a shape to the row's window, and sets what of the row lies inside. */
    void (*add)(qtri_stroke_window *window, qtri_stroke_shape *shape);
    /* Finds what parts cover together where several cover a pixel in part. */
    void (*unite)(qtri_stroker *stroker);
    /* Draws a round point that is small; false: the part is something else. */
    bool (*point)(qtri_stroker *stroker, const qtri_stroke_place *place);
    qtri_line_draws line; /* thin ones, each by itself: see line.h */
};

/* False: nothing can be drawn. Then parts of any source. */
bool qtri_stroker_init(qtri_stroker *stroker, const qtri_surface *surface,
                       const qtri_material *material, const qtri_stroke *stroke);
void qtri_stroker_draw(qtri_stroker *stroker, const qtri_stroke_source *source);

/* One part by itself, of stroker->look. */
void qtri_stroker_draw_part(qtri_stroker *stroker, const qtri_stroke_place *place);

/*
 * The shapes that touch columns first .. end-1 of the window: *at is 0 at first, and counts on.
 * NULL behind the last. A shape is there until the next is asked for.
 */
qtri_stroke_shape *qtri_stroker_next(qtri_stroker *stroker, uint32_t *at, int32_t first,
                                     int32_t end);

/* Half of a width in 24.8; 0: nothing is drawn. */
static inline int32_t qtri_stroke_radius(q16 width)
{
    const q16 max = QTRI_STROKE_WIDTH_MAX * Q16_ONE;
    return width <= 0 ? 0 : (qtri_least32(width, max) + 256) >> 9;
}

static inline uint8_t qtri_stroke_cap(const qtri_stroke *stroke)
{
    const bool is_flat = stroke->cap == QTRI_CAP_BUTT || stroke->cap == QTRI_CAP_SQUARE;
    return (uint8_t)(is_flat ? stroke->cap : QTRI_CAP_ROUND);
}

#endif
