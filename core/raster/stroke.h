/* SPDX-License-Identifier: MIT */
/*
 * Strokes: the union of the shapes of a line's parts, row by row. Internal.
 *
 * A part, the segment from a to b, is a convex shape: a rectangle and, at joints and round ends, a
 * disc. The picture is drawn in strips of 32 columns that begin at multiples of 32, row by row. In
 * a row of a strip, parts whose columns touch are a group: their union is found together. What a
 * pixel becomes depends on the row, the strip and the parts, never on what a band or a scissor
 * leave of them.
 */
#ifndef QTRI_RASTER_STROKE_H
#define QTRI_RASTER_STROKE_H

#include "qtri/stroke.h"

#include "../bits/bits.h"
#include "line.h"
#include "stroke_shape.h"

enum {
    QTRI_STROKE_WINDOW = 32, /* columns of a strip */
    QTRI_STROKE_SHAPES = 8,  /* that are kept from row to row */
    QTRI_STROKE_PARTS = 16,  /* of a strip or a row whose numbers are kept */
    QTRI_STROKE_MARKED = 256 /* first parts, that are marked where they may touch the rows */
};

/* Parts 0 .. count-1. `place` is asked in every row, and says false of what is not to be seen. */
typedef struct qtri_stroke_source {
    const void *from;
    uint32_t count;
    bool (*place)(const void *from, uint32_t part, qtri_stroke_place *place);
    void (*ends)(const void *from, uint32_t part, qtri_stroke_end end[2]);
} qtri_stroke_source;

/* A part that may touch a row of the strip, in these columns. */
typedef struct qtri_stroke_touch {
    uint32_t part;
    int16_t first, end; /* of the frame: within 2^14 and three radii */
} qtri_stroke_touch;

typedef struct qtri_stroker {
    const qtri_surface *surface;
    const qtri_stroke_source *source;
    qtri_rect bounds;
    qtri_compare compare;
    bool depth_write;
    uint8_t passing; /* of a depth: bit 0 if less passes, bit 1 if equal does, bit 2 if greater */
    uint8_t first, end; /* columns of the strip that the row's parts touch */
    uint8_t alpha;      /* 1..255 */
    const qtri_stroke_edges *edges;
    const qtri_material *material;
    const qtri_effect_stages *effects; /* its fog and blend; NULL: neither */
    int32_t column, row;               /* of the strip */
    uint32_t part[QTRI_STROKE_PARTS];  /* that may touch the strip, in their order */
    uint32_t part_count;               /* and */
    uint32_t rest;                     /*   from which on others may follow; UINT32_MAX: none */
    uint32_t marks[QTRI_STROKE_MARKED / 32];
    qtri_stroke_touch touch[QTRI_STROKE_PARTS]; /* of the row, by their first columns */
    uint32_t touch_count; /* QTRI_STROKE_MANY: more than there is room for are one group */
    uint32_t first_touch, touch_end; /* of the group */
    qtri_stroke_shape shape[QTRI_STROKE_SHAPES];
    int32_t cover[QTRI_STROKE_WINDOW + 1]; /* of those pixels, QTRI_STROKE_FULL at most */
} qtri_stroker;

#define QTRI_STROKE_MANY UINT32_MAX

struct qtri_stroke_edges {
    /* Adds the parts of the group to stroker->cover; then makes of the sums what pixels have. */
    void (*add)(qtri_stroker *stroker);
    void (*finish)(qtri_stroker *stroker);
    qtri_line_draws line; /* thin ones, each by itself: see stroke_line.h */
};

/* False: nothing can be drawn. Then parts of any source. */
bool qtri_stroker_init(qtri_stroker *stroker, const qtri_surface *surface,
                       const qtri_material *material, const qtri_stroke *stroke);
void qtri_stroker_draw(qtri_stroker *stroker, const qtri_stroke_source *source);

/* Takes a source's parts; columns that they may touch, inside the bounds, from [0] to before [1].
 */
void qtri_stroker_begin(qtri_stroker *stroker, const qtri_stroke_source *source,
                        int32_t columns[2]);

/* Lists the parts of the strip that begins at `column`, and finds its rows, likewise. */
void qtri_stroker_find_parts(qtri_stroker *stroker, int32_t rows[2]);

/* Lists those that touch the row, by their first columns. False: none. */
bool qtri_stroker_find_touches(qtri_stroker *stroker);

/* The shape of a part that is there. Of eight parts that follow each other all are kept. */
qtri_stroke_shape *qtri_stroker_shape(qtri_stroker *stroker, uint32_t part);

/* The group of touches from `from` on: those whose columns follow or cover each other. */
void qtri_stroker_set_group(qtri_stroker *stroker, uint32_t from);

/*
 * The parts of the group: *at is 0 at first, and counts on. NULL behind the last. A shape is there
 * until the next is asked for.
 */
qtri_stroke_shape *qtri_stroker_next(qtri_stroker *stroker, uint32_t *at);

/* Draws pixels first .. end-1 of the row, up to a strip of them, that one part covers wholly. */
void qtri_stroke_run(const qtri_stroker *stroker, const qtri_stroke_shape *shape, int32_t first,
                     int32_t end);

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
