/* SPDX-License-Identifier: MIT */
/*
 * A smooth line while it is drawn (stroke_line.c), and what stores its pixels. Internal.
 */
#ifndef QTRI_RASTER_STROKE_WIRE_H
#define QTRI_RASTER_STROKE_WIRE_H

#include "batch.h"
#include "line.h"

/*
 * A line by its longer axis, "along", and the other, "across". Its rectangle's corners lie at an
 * end less the offset, on the near side, and at the end plus the offset, on the far one:
 * (offset_x, -offset_y) from it. 24.8 where nothing else is said.
 */
typedef struct qtri_wire {
    const qtri_line_job *job;
    int32_t x[2], y[2];         /* of the ends, along and across; x[0] < x[1] */
    int32_t origin_x, origin_y; /* of the first end, without a cap */
    int32_t slope_q16;          /* across for along: -1..1 */
    uint32_t slope_q30;         /* its magnitude */
    int32_t inverse_q8;         /* along for across, its magnitude, at most 2^22 */
    int32_t offset_x, offset_y; /* |offset_x| <= offset_y <= radius */
    int32_t half_q16;           /* of its extent across, in a column: <= sqrt(2) pixels */
    int32_t first, end;         /* columns */
    int32_t inner, inner_end;   /* those where it has no end */
    int32_t bounds[4];          /* pixels inside: along from, to; across from, to */
    bool inside;                /* all of it lies in them */
    int32_t share_step;         /* Q24 of its length a column; at most 2^28 */
    int32_t share_across;       /* the same for a pixel across */
    int32_t z_16p14, z_step;    /* at the first end; from end to end */
    int32_t z_16p8, z_delta;    /* the same, unrounded */
    int32_t light_q29, light_step;
    const qtri_line_color *from, *to; /* NULL: shares of the tint */
    uint32_t alpha_q8;                /* 256: opaque */
    uint32_t place_along, place_across;
    bool steep; /* along is y */
    /* Where pixels are stored as they are found: row 0 of the frame, and bytes. */
    const uint16_t *table;
    uint8_t *pixels, *depths;
    int32_t pixel_along, pixel_across, depth_along, depth_across;
} qtri_wire;

/*
 * Pixels of a line on their way. Of each, in one word: its share of the line's length, whether its
 * depth is written when fog and a blend have not turned it away, and what of it is covered,
 * 0..1024.
 */
typedef struct qtri_wire_pixels {
    int32_t count;
    uint32_t place[QTRI_BATCH];
    uint32_t word[QTRI_BATCH];
} qtri_wire_pixels;

enum {
    QTRI_WIRE_SHARE_BITS = 14,
    QTRI_WIRE_LATE_BIT = QTRI_WIRE_SHARE_BITS + 1,
    QTRI_WIRE_COVER_AT = 16
};

static inline int32_t qtri_wire_share_of(uint32_t word)
{
    return (int32_t)(word & (((uint32_t)1 << QTRI_WIRE_LATE_BIT) - 1));
}

/* 16.16, for depths that are no linear16; without the last bit, which tells of other things. */
uint32_t qtri_wire_fine_depth(const qtri_wire *w, int32_t share);

/* Stores what there is, with fog and a blend, and empties it. No pixel is there twice. */
void qtri_wire_store(const qtri_wire *w, qtri_wire_pixels *p);

#endif
