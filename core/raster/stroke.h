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

enum {
    QTRI_STROKE_WINDOW = 32, /* columns of a strip */
    QTRI_STROKE_SHAPES = 8,  /* that are kept from row to row */
    QTRI_STROKE_PARTS = 16   /* of a strip or a row whose numbers are kept */
};

/* What covers a whole pixel. */
#define QTRI_STROKE_FULL ((int32_t)256 * 512)

/* Where a part is. */
typedef struct qtri_stroke_place {
    qtri_screen_point end[2]; /* within +-QTRI_SCREEN_MAX_24P8 */
    int32_t radius_24p8;      /* 1..2^16 */
    uint8_t caps[2];          /* qtri_cap of the ends; joints are round */
} qtri_stroke_place;

/* What an end looks like. */
typedef struct qtri_stroke_end {
    uint32_t depth_16p8; /* 0..65535.0 */
    int32_t color_8p16[3];
} qtri_stroke_end;

/* Parts 0 .. count-1. `place` is asked in every row, and says false of what is not to be seen. */
typedef struct qtri_stroke_source {
    const void *from;
    uint32_t count;
    bool (*place)(const void *from, uint32_t part, qtri_stroke_place *place);
    void (*ends)(const void *from, uint32_t part, qtri_stroke_end end[2]);
} qtri_stroke_source;

/*
 * A part made ready. a is its upper end. The rectangle's corners are a and b plus and minus
 * `offset`; slopes are x for y along its long sides and its ends.
 */
typedef struct qtri_stroke_shape {
    uint32_t part; /* UINT32_MAX: none */
    qtri_screen_point a, b, origin;
    int32_t radius;
    int32_t offset_x, offset_y;
    int64_t slope_q32, end_slope_q32;
    uint8_t discs;         /* bit 0: around a, bit 1: around b */
    bool is_disc;          /* a round point: the one around a is all of it */
    bool even;             /* one colour, */
    bool level;            /*   and one depth */
    int32_t disc_level[2]; /* of the last chord, and half its length */
    int32_t disc_half[2];
    int32_t side_level[2], side_x[2]; /* the same of the long sides */
    /* From `origin`, the first end as it was given, along the part: */
    int32_t along_x_q30, along_y_q30; /* its direction */
    uint32_t length;                  /* in 24.8, times 2^up: 2^30..2^31; 0: none */
    uint8_t up;                       /* 6..30 */
    uint8_t inverse_shift; /* a position times 2^up and `inverse`, so far down: a share in Q16 */
    uint32_t inverse;      /* of `length` */
    qtri_stroke_end end[2];
} qtri_stroke_shape;

void qtri_stroke_shape_init(qtri_stroke_shape *shape, const qtri_stroke_place *place);

/* y of a part's line at an x between those of its ends, which differ; within 2 of 1/256. */
int32_t qtri_stroke_line_y(const qtri_stroke_place *place, int32_t x_24p8);

/* The columns that it may touch in a row: first and past the last. False: none. */
bool qtri_stroke_shape_columns(const qtri_stroke_shape *shape, int32_t row, int32_t *first,
                               int32_t *end);

/*
 * From the level y0 to y1, in between of which no side begins or ends: the left and right bounds at
 * both. False: it is not there.
 */
typedef struct qtri_stroke_slice {
    int32_t left[2], right[2]; /* at y0 and y1, 24.8 */
} qtri_stroke_slice;
bool qtri_stroke_shape_slice(qtri_stroke_shape *shape, int32_t y0, int32_t y1,
                             qtri_stroke_slice *slice);

/*
 * Marks the levels from `top` to `top` + 255 where a side or a disc begins or ends: 32 in each
 * word, the first in its lowest bit.
 */
void qtri_stroke_shape_breaks(const qtri_stroke_shape *shape, int32_t top, uint32_t levels[8]);

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
    qtri_stroke_touch touch[QTRI_STROKE_PARTS]; /* of the row, by their first columns */
    uint32_t touch_count; /* QTRI_STROKE_MANY: more than there is room for are one group */
    uint32_t first_touch, touch_end; /* of the group */
    qtri_stroke_shape shape[QTRI_STROKE_SHAPES];
    int32_t cover[QTRI_STROKE_WINDOW + 1]; /* of each of those pixels, 0..QTRI_STROKE_FULL */
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

/* 1 if a depth passes the test, whose three bits are a stroker's `passing`; else 0. */
static inline uint32_t qtri_stroke_passes(uint32_t passing, uint32_t depth, uint32_t stored)
{
    const uint32_t which = depth < stored ? 0 : (depth == stored ? 1 : 2);
    return passing >> which & 1;
}

/* from + (to - from) share / 2^16; |to - from| < 2^24. */
static inline int32_t qtri_stroke_mixed(int32_t from, int32_t to, uint32_t share_q16)
{
    return from + (int32_t)((qtri_mul_s32(to - from, (int32_t)share_q16) + 0x8000) >> 16);
}

/* The depth of a part at a share of its length, 0..65535.0 in 16.8. */
static inline uint32_t qtri_stroke_depth(const qtri_stroke_shape *shape, uint32_t share_q16)
{
    const int32_t from = (int32_t)(shape->end[0].depth_16p8 >> 8);
    const int32_t to = (int32_t)(shape->end[1].depth_16p8 >> 8);
    return (uint32_t)qtri_stroke_mixed(from, to, share_q16);
}

/*
 * Where along a part the centres of pixels of a row are: x, y from its origin. The share of its
 * length is that of along_q30, held to the part.
 */
typedef struct qtri_stroke_walk {
    int64_t along_q30, length_q30, step_q30;
    uint32_t inverse;
    int32_t down, inverse_shift;
} qtri_stroke_walk;

/* |x|, |y| < 2^24: below 2^55. */
static inline qtri_stroke_walk qtri_stroke_walk_from(const qtri_stroke_shape *shape, int32_t x,
                                                     int32_t y)
{
    const int32_t down = 30 - shape->up;
    const qtri_stroke_walk walk = {qtri_mul_s32(x, shape->along_x_q30) +
                                       qtri_mul_s32(y, shape->along_y_q30),
                                   (int64_t)((uint64_t)shape->length << down),
                                   (int64_t)shape->along_x_q30 * 256,
                                   shape->inverse,
                                   down,
                                   shape->inverse_shift};
    return walk;
}

static inline int64_t qtri_stroke_walk_held(const qtri_stroke_walk *walk)
{
    const int64_t along_q30 = walk->along_q30;
    return along_q30 < 0 ? 0 : (along_q30 > walk->length_q30 ? walk->length_q30 : along_q30);
}

/* < 2^16: length times inverse is below 2^62. */
static inline uint32_t qtri_stroke_walk_share(const qtri_stroke_walk *walk, int64_t held_q30)
{
    const uint64_t product = qtri_mul_u32((uint32_t)(held_q30 >> walk->down), walk->inverse);
    return (uint32_t)(product >> walk->inverse_shift);
}

/* The share at a pixel, and on to the next. */
static inline uint32_t qtri_stroke_walk_next(qtri_stroke_walk *walk)
{
    const uint32_t share_q16 = qtri_stroke_walk_share(walk, qtri_stroke_walk_held(walk));
    walk->along_q30 += walk->step_q30;
    return share_q16;
}

/* cover alpha / 255 in Q16: 32897 / 2^23 is 1 / 255 within 2^-30. */
static inline int32_t qtri_stroke_share(const qtri_stroker *stroker, int32_t cover)
{
    if (stroker->alpha == 255) {
        return cover >> 1;
    }
    return (int32_t)((uint32_t)(cover >> 2) * ((stroker->alpha * 32897u) >> 8) >> 14);
}

/* Draws pixels first .. end-1 of the row, up to a strip of them, that one part covers wholly. */
void qtri_stroke_run(const qtri_stroker *stroker, const qtri_stroke_shape *shape, int32_t first,
                     int32_t end);

/* A colour, or what a share of it, 0..2^16, makes of a stored pixel, before it is encoded. */
static inline uint32_t qtri_stroke_word(const qtri_format *format, const int32_t color_8p16[3],
                                        const uint8_t *pixel, int32_t share_q16)
{
    int32_t color[3] = {color_8p16[0], color_8p16[1], color_8p16[2]};
    if (share_q16 < 65536) {
        const uint32_t stored = format->decode(format->pixels->load(pixel));
        for (int i = 0; i < 3; i++) {
            const int32_t below = (int32_t)(stored >> (16 - 8 * i) & 0xFFu) << 16;
            /* |.| <= 255 2^7 2^16 < 2^31 */
            color[i] = below + ((((color[i] - below) >> 9) * share_q16) >> 7);
        }
    }
    const qtri_channels channels = qtri_channels_from_color(format->colors, color);
    return format->colors->pack(channels.c);
}

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
