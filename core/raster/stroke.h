/* SPDX-License-Identifier: MIT */
/*
 * Strokes: the union of the shapes of a line's parts. Internal.
 *
 * A part, the segment from a to b, is a convex shape: a rectangle and, at joints and round ends, a
 * disc. Parts are drawn one after the other, row by row. A pixel that several of them touch is
 * drawn with the first of them, as what all of these cover together; the others leave it out. What
 * a pixel becomes depends on the parts, never on what a band or a scissor leave of them.
 */
#ifndef QTRI_RASTER_STROKE_H
#define QTRI_RASTER_STROKE_H

#include "qtri/stroke.h"

#include "../bits/bits.h"
#include "draw_state.h"
#include "line.h"
#include "stroke_shape.h"

enum {
    QTRI_STROKE_WINDOW = 32,     /* columns that are looked at together, from a multiple of it on */
    QTRI_STROKE_SHAPES = 8,      /* that are kept */
    QTRI_STROKE_NEIGHBOURS = 24, /* of a part whose numbers are kept */
    QTRI_STROKE_GROUP = 8,
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

/* A part that comes near the one that is drawn: the rows that it may touch. */
typedef struct qtri_stroke_neighbour {
    uint32_t part;
    int16_t y0, y1;
} qtri_stroke_neighbour;

/* Half of a polygon around a disc, from its top down, by what small round points are drawn. */
typedef struct qtri_stroke_ring {
    int32_t radius; /* 0: none yet */
    int32_t count;
    struct {
        int32_t y, half;     /* from the centre */
        int32_t slope_q16;   /* of half, from here to the next */
        int32_t inverse_q16; /* 1 / |slope| */
    } at[QTRI_STROKE_RING];
} qtri_stroke_ring;

typedef struct qtri_stroker {
    const qtri_stroke_source *source;
    const qtri_stroke_edges *edges;
    qtri_stroke_target to;
    qtri_stroke_shape *own;                          /* the part that is drawn */
    qtri_stroke_shape shape[QTRI_STROKE_SHAPES + 1]; /* the last is the own one */
    qtri_stroke_shape disc;                          /* of the last shape that has one apart */
    qtri_stroke_neighbour neighbour[QTRI_STROKE_NEIGHBOURS];
    uint32_t neighbour_count;
    uint32_t rest; /* from which on there may be more of them; UINT32_MAX: none */
    qtri_stroke_box block[QTRI_STROKE_BLOCKS];
    uint32_t block_parts;              /* of one */
    uint32_t group[QTRI_STROKE_GROUP]; /* later parts that reach into the row's columns, and */
    uint32_t group_count;              /* how many: of more than there is room for one too many */
    bool is_alike;                     /* they have one colour and depth */
    qtri_stroke_ring ring;
    /* The row, and columns of it, at most a window. */
    int32_t row;
    int32_t first, end;
    bool is_alone;
    int32_t cover[QTRI_STROKE_WINDOW + 1]; /* of the window, at most QTRI_STROKE_FULL */
} qtri_stroker;

struct qtri_stroke_edges {
    /* Makes cover[] of the own part and all that reach into the row's columns with it. */
    void (*cover)(qtri_stroker *stroker);
    /* Draws a round point that is small; false: the part is something else. */
    bool (*point)(qtri_stroker *stroker, const qtri_stroke_place *place,
                  const qtri_stroke_end end[2]);
    qtri_line_draws line; /* thin ones, each by itself: see stroke_line.h */
};

/* False: nothing can be drawn. Then parts of any source. */
bool qtri_stroker_init(qtri_stroker *stroker, const qtri_surface *surface,
                       const qtri_material *material, const qtri_stroke *stroke);
void qtri_stroker_draw(qtri_stroker *stroker, const qtri_stroke_source *source);

/* One part by itself. */
void qtri_stroker_draw_part(qtri_stroker *stroker, const qtri_stroke_place *place,
                            const qtri_stroke_end end[2]);

/*
 * The shapes that reach into the row's columns, the own part's first: *at is 0 at first, and counts
 * on. NULL behind the last. A shape is there until the next is asked for.
 */
qtri_stroke_shape *qtri_stroker_next(qtri_stroker *stroker, uint32_t *at);

/* Smooth edges' `point`. */
bool qtri_stroke_point_draw(qtri_stroker *stroker, const qtri_stroke_place *place,
                            const qtri_stroke_end end[2]);

/* Half of a width in 24.8; 0: nothing is drawn. */
static inline int32_t qtri_stroke_radius(q16 width)
{
    const q16 most = QTRI_STROKE_WIDTH_MAX * Q16_ONE;
    return width <= 0 ? 0 : (qtri_least32(width, most) + 256) >> 9;
}

static inline uint8_t qtri_stroke_cap(const qtri_stroke *stroke)
{
    const bool is_flat = stroke->cap == QTRI_CAP_BUTT || stroke->cap == QTRI_CAP_SQUARE;
    return (uint8_t)(is_flat ? stroke->cap : QTRI_CAP_ROUND);
}

static inline int32_t qtri_stroke_hold(int32_t x)
{
    return qtri_hold32(x, -QTRI_SCREEN_MAX_24P8, QTRI_SCREEN_MAX_24P8);
}

#endif
