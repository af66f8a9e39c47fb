/* SPDX-License-Identifier: MIT */
/*
 * The convex shape of one part of a stroke: its left and right bounds by row, and shares of its
 * length at pixels. Internal.
 *
 * A bound of the shape, the left or the right one, leads around the upper end, along a side of the
 * rectangle, and around the lower end. It is asked for in pieces, which are straight: an end is
 * flat, or an arc of a polygon around the disc.
 */
#ifndef QTRI_RASTER_STROKE_SHAPE_H
#define QTRI_RASTER_STROKE_SHAPE_H

#include "qtri/stroke.h"

#include "../bits/bits.h"

/* A part's position. */
typedef struct qtri_stroke_place {
    qtri_point end[2];   /* within +-QTRI_SCREEN_MAX_24P8 */
    int32_t radius_24p8; /* 1..2^16 */
    uint8_t caps[2];     /* qtri_cap of the ends; joints are round */
} qtri_stroke_place;

/*
 * A quarter of a polygon of a disc's area, from its top to its side. Vertices lie (k / 4)^2 pixels
 * below the top: the area between the arc and a chord is sqrt(2 r) / 6 times the cube of the
 * difference of both roots, 1/64, which is .0026 sqrt(2 r) at most. Small discs have regular
 * polygons of 8 to 16 vertices.
 */
enum { QTRI_STROKE_RING = 66 };

typedef struct qtri_stroke_ring {
    int32_t radius;
    int32_t last; /* the vertex at the side */
    bool is_regular;
    uint16_t half[QTRI_STROKE_RING];     /* of the chord there, 1/256 pixel */
    int32_t slope_q16[QTRI_STROKE_RING]; /* of `half`, from here down to the next vertex */
} qtri_stroke_ring;

void qtri_stroke_ring_init(qtri_stroke_ring *ring, int32_t radius);

/* A straight piece of a bound: top <= y < bottom. */
typedef struct qtri_stroke_piece {
    int32_t top, bottom;
    int32_t x0, x1; /* at its top, and at its bottom */
    int32_t slope_q16;
    int32_t vertex; /* of an arc: index of the ring's vertex that begins it */
} qtri_stroke_piece;

/*
 * The set-up of a part. a is its upper end, a square cap included. The rectangle's corners are a
 * and b plus and minus `offset`.
 */
typedef struct qtri_stroke_shape {
    uint32_t part;                /* UINT32_MAX: none */
    const qtri_stroke_ring *ring; /* of its radius; NULL: arcs are exact, level by level */
    qtri_point a, b;
    int32_t radius;
    int32_t offset_x, offset_y; /* offset_y >= 0 */
    int32_t top, bottom;
    int64_t slope_q32; /* x for y along the long sides */
    uint8_t cut;       /* their pieces are 2^cut high */
    bool round_a, round_b;
    bool is_left;               /* a + offset is on the left bound, a - offset on the right one */
    qtri_stroke_piece piece[2]; /* of the left bound and of the right one, found last */
    int32_t min_x, max_x;       /* of the row: columns covered, 24.8 */
    uint8_t share_shift;        /* 6..31 */
    qtri_point origin;          /* the first end without a cap; along the part: */
    int32_t along_x_q30, along_y_q30; /* direction */
    int32_t length_24p8;              /* rounded */
    int32_t share_x, share_y;         /* of its length a unit, times 2^(share_shift - 24) */
} qtri_stroke_shape;

void qtri_stroke_shape_init(qtri_stroke_shape *shape, const qtri_stroke_place *place,
                            const qtri_stroke_ring *ring);

/* Finds the piece of the left (0) or right (1) bound that has a level, top <= y < bottom. */
void qtri_stroke_shape_find(qtri_stroke_shape *shape, int side, int32_t y);

static inline const qtri_stroke_piece *qtri_stroke_shape_piece(qtri_stroke_shape *shape, int side,
                                                               int32_t y)
{
    qtri_stroke_piece *piece = &shape->piece[side];
    if (y >= piece->bottom || y < piece->top) {
        qtri_stroke_shape_find(shape, side, y);
    }
    return piece;
}

/* x at a level of the piece, its bottom included. */
static inline int32_t qtri_stroke_piece_x(const qtri_stroke_piece *piece, int32_t y)
{
    return y == piece->bottom
               ? piece->x1
               : piece->x0 + ((piece->slope_q16 * (y - piece->top) + 0x8000) >> 16); /* < 2^31 */
}

/* A share of the part's length, clamped to 0..1: Q24 to 16 bits. */
static inline uint16_t qtri_stroke_clamped_share(int32_t share_q24)
{
    return (uint16_t)(qtri_hold32(share_q24, 0, (1 << 24) - 1) >> 8);
}

/* Shares of the part's length, 16 bits each, at the centres of `count` pixels from (x, y) on. */
void qtri_stroke_shape_shares(const qtri_stroke_shape *shape, int32_t x, int32_t y, int32_t count,
                              uint16_t *share_q16);

/* The square of the distance from a pixel's centre to the part's segment, 24.8, of which each
   component is 2^22 at most. */
uint64_t qtri_stroke_shape_distance(const qtri_stroke_shape *shape, int32_t x, int32_t y);

#endif
