/* SPDX-License-Identifier: MIT */
/*
 * One part of a stroke: the convex shape that it is, and where along its length pixels are.
 * Internal.
 */
#ifndef QTRI_RASTER_STROKE_SHAPE_H
#define QTRI_RASTER_STROKE_SHAPE_H

#include "qtri/stroke.h"

#include "../bits/bits.h"

/* A part's position. */
typedef struct qtri_stroke_place {
    qtri_screen_point end[2]; /* within +-QTRI_SCREEN_MAX_24P8 */
    int32_t radius_24p8;      /* 1..2^16 */
    uint8_t caps[2];          /* qtri_cap of the ends; joints are round */
} qtri_stroke_place;

/*
 * A part made ready. a is its upper end, a cap included. The rectangle's corners are a and b plus
 * and minus `offset`. A bound of the shape leads around the upper end, along a side of the
 * rectangle, and around the lower end; an end is an arc or straight.
 */
typedef struct qtri_stroke_shape {
    uint32_t part; /* UINT32_MAX: none */
    qtri_screen_point a, b;
    int32_t radius;
    int32_t offset_x, offset_y; /* offset_y >= 0 */
    int32_t top, bottom;
    int64_t slope_q32, end_slope_q32; /* x for y along the long sides and the ends */
    int32_t slope_q16;                /* that of the long sides where the shape is short */
    int32_t level[2], half[2];        /* the last half chords of the discs around a and b */
    int32_t row;                      /* what of this row lies inside; INT32_MAX: of none yet */
    int32_t min_x, max_left, min_right, max_x; /* bounds of its left and its right side */
    bool round_a, round_b;
    bool is_short;
    bool is_left;        /* a + offset is on the left bound, a - offset on the right one */
    uint8_t apart;       /* a disc around a (1) or b (2) reaches out of the other, flat end, and
                            is no part of this shape; 0: none */
    uint8_t more;        /* added to half of a disc's chord, see QTRI_STROKE_CHORDS */
    uint8_t share_shift; /* 6..31 */
    qtri_screen_point origin;         /* the first end without a cap; along the part: */
    int32_t along_x_q30, along_y_q30; /* direction */
    int32_t length_24p8;              /* rounded */
    int32_t share_x, share_y;         /* of its length a unit, times 2^(share_shift - 24) */
} qtri_stroke_shape;

/*
 * `more` of smooth edges: straight bounds from level to level leave out what lies between an arc
 * and its chords, which so many 1/256 of a pixel make up for in the mean.
 */
enum { QTRI_STROKE_CHORDS = 2 };

/* Half of the chord of a disc at a level so far from its centre, |down| < radius. */
int32_t qtri_stroke_half_chord(int32_t radius, int32_t down);

void qtri_stroke_shape_init(qtri_stroke_shape *shape, const qtri_stroke_place *place, int32_t more);

/* The disc that is apart, as a shape. */
void qtri_stroke_shape_disc(qtri_stroke_shape *disc, const qtri_stroke_shape *shape);

/*
 * x of the left (0) or right (1) bound at a level, top <= y <= bottom. `below`: as it is from there
 * down; else as it ends there, from above.
 */
int32_t qtri_stroke_shape_x(qtri_stroke_shape *shape, int side, int32_t y, bool below);

/*
 * The next level below y, top <= y < bottom, up to which the bound is taken as straight. Levels
 * that follow each other around the top of a disc are u = (k / 4)^2 pixels below it: the area
 * between the arc and a chord is sqrt(2 r) / 6 times the cube of the difference of both roots,
 * 1/64, which is .0026 sqrt(2 r) at most.
 */
int32_t qtri_stroke_shape_next(const qtri_stroke_shape *shape, int side, int32_t y);

/* Whether both bounds are straight between two levels. */
static inline bool qtri_stroke_shape_is_straight(const qtri_stroke_shape *s, int32_t y0, int32_t y1)
{
    return s->a.y_24p8 + s->offset_y <= y0 && s->b.y_24p8 - s->offset_y >= y1;
}

/* Shares of the part's length, 16 bits each, at the centres of `count` pixels from (x, y) on. */
void qtri_stroke_shape_shares(const qtri_stroke_shape *shape, int32_t x, int32_t y, int32_t count,
                              uint16_t *share_q16);

/* The square of the distance from a pixel's centre to the part's line, far away taken as 2^22. */
uint64_t qtri_stroke_shape_distance(const qtri_stroke_shape *shape, int32_t x, int32_t y);

#endif
