/* SPDX-License-Identifier: MIT */
/*
 * One part of a stroke: the shape that it is, row by row, and what it looks like along its length.
 * Internal.
 */
#ifndef QTRI_RASTER_STROKE_SHAPE_H
#define QTRI_RASTER_STROKE_SHAPE_H

#include "qtri/stroke.h"

#include "../bits/bits.h"

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
    uint8_t disc_apart;    /* in place of `discs`, of a part so short that its disc reaches out of
                              the other, flat end: the two are not convex */
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
 * both.
 */
typedef struct qtri_stroke_slice {
    int32_t left[2], right[2]; /* at y0 and y1, 24.8 */
} qtri_stroke_slice;

/* Without a disc that is apart. False: it is not there. */
bool qtri_stroke_shape_slice(qtri_stroke_shape *shape, int32_t y0, int32_t y1,
                             qtri_stroke_slice *slice);

/* The disc that is apart. */
bool qtri_stroke_shape_disc(qtri_stroke_shape *shape, int32_t y0, int32_t y1,
                            qtri_stroke_slice *slice);

/*
 * Marks the levels from `top` to `top` + 255 where a side or a disc begins or ends: 32 in each
 * word, the first in its lowest bit.
 */
void qtri_stroke_shape_breaks(const qtri_stroke_shape *shape, int32_t top, uint32_t levels[8]);

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

#endif
