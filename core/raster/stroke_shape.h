/* SPDX-License-Identifier: MIT */
/*
 * One part of a stroke: the convex shape that it is, and where along its length pixels are.
 * Internal.
 */
#ifndef QTRI_RASTER_STROKE_SHAPE_H
#define QTRI_RASTER_STROKE_SHAPE_H

#include "qtri/stroke.h"

#include "../bits/bits.h"
#include "stroke_span.h"

/* Where a part is. */
typedef struct qtri_stroke_place {
    qtri_screen_point end[2]; /* within +-QTRI_SCREEN_MAX_24P8 */
    int32_t radius_24p8;      /* 1..2^16 */
    uint8_t caps[2];          /* qtri_cap of the ends; joints are round */
} qtri_stroke_place;

/*
 * The left or the right bound of a shape, from its top down: around the upper end, along a side,
 * and around the lower end. An end is an arc or straight.
 */
typedef struct qtri_stroke_chain {
    int32_t y0, y1;         /* of the side */
    int32_t x;              /* of the side at y0 */
    int32_t peak_x, peak_y; /* where it is furthest out */
} qtri_stroke_chain;

/*
 * A part made ready. a is its upper end, a cap included. The rectangle's corners are a and b plus
 * and minus `offset`; slopes are x for y along its long sides and its ends.
 */
typedef struct qtri_stroke_shape {
    uint32_t part; /* UINT32_MAX: none */
    qtri_screen_point a, b;
    int32_t radius;
    int32_t offset_x, offset_y;
    int32_t top, bottom;
    int32_t more; /* added to half of a disc's chord, see QTRI_STROKE_CHORDS */
    int64_t slope_q32, end_slope_q32;
    qtri_stroke_chain chain[2]; /* left, right */
    bool round_a, round_b;
    bool is_short; /* slopes serve in 16 bits, slope_q16, for all of it */
    int32_t slope_q16;
    uint8_t apart; /* a disc around a (1) or b (2) reaches out of the other, flat end, and
                      is no part of this shape; 0: none */
    int32_t level[2], half[2];     /* the last chords of the discs */
    int32_t last_level, last_x[2]; /* where the last slice ended, see stroke_smooth.c */
    /* Along the part, from `origin`, the first end as it was given: */
    qtri_screen_point origin;
    int32_t along_x_q30, along_y_q30; /* its direction */
    int32_t length_24p8;              /* rounded */
    int32_t share_x, share_y;         /* of its length a unit, times 2^(share_shift - 24) */
    uint8_t share_shift;              /* 6..31 */
    qtri_stroke_look look;
} qtri_stroke_shape;

/*
 * `more` of smooth edges: straight bounds from level to level leave out what lies between an arc
 * and its chords, which so many 1/256 of a pixel make up for in the mean.
 */
enum { QTRI_STROKE_CHORDS = 2 };

/* Half of the chord of a disc at a level so far from its centre, |down| < radius. */
int32_t qtri_stroke_half_chord(int32_t radius, int32_t down);

/* Without the look. */
void qtri_stroke_shape_init(qtri_stroke_shape *shape, const qtri_stroke_place *place, int32_t more);

/* The disc that is apart, as a shape. */
void qtri_stroke_shape_disc(qtri_stroke_shape *disc, const qtri_stroke_shape *shape);

/*
 * x of the left (0) or right (1) bound at a level, top <= y <= bottom. `below`: as it is from there
 * down; else as it ends there, from above.
 */
int32_t qtri_stroke_shape_x(qtri_stroke_shape *shape, int side, int32_t y, bool below);

/* What of the rows' levels y0 <= y < y1 it touches: x from first to end. False: nothing. */
bool qtri_stroke_shape_reach(qtri_stroke_shape *shape, int32_t y0, int32_t y1, int32_t x[2]);

/*
 * Marks levels from `top` to `top` + 255 where a bound turns, or an arc is cut into chords: 32 in
 * each word, the first in its lowest bit. Levels that follow each other around the top of a disc
 * are u = (k / 4)^2 pixels below it: the area between the arc and a chord is sqrt(2 r) / 6 times
 * the cube of the difference of both roots, 1/64, which is .0026 sqrt(2 r) at most.
 */
void qtri_stroke_shape_mark(const qtri_stroke_shape *shape, int32_t top, uint32_t levels[8]);

/* Whether both bounds are straight between two levels. */
static inline bool qtri_stroke_shape_is_straight(const qtri_stroke_shape *s, int32_t y0, int32_t y1)
{
    return s->chain[0].y0 <= y0 && s->chain[1].y0 <= y0 && s->chain[0].y1 >= y1 &&
           s->chain[1].y1 >= y1;
}

/* Shares of the part's length, 16 bits each, at the centres of `count` pixels from (x, y) on. */
void qtri_stroke_shape_shares(const qtri_stroke_shape *shape, int32_t x, int32_t y, int32_t count,
                              uint16_t *share_q16);

/* The square of the distance from a pixel's centre to the part's line, far away taken as 2^22. */
uint64_t qtri_stroke_shape_distance(const qtri_stroke_shape *shape, int32_t x, int32_t y);

#endif
