/* SPDX-License-Identifier: MIT */
/*
 * A brush set up for a surface, and spans, rectangles and glyphs painted by it. Internal.
 */
#ifndef QTRI_PAINT_PAINTER_H
#define QTRI_PAINT_PAINTER_H

#include <stdbool.h>

#include "qtri/error.h"
#include "qtri/paint.h"

#include "../frame/pixel.h"

struct qtri_contour;

/* A brush set up for a surface. */
typedef struct qtri_painter {
    const qtri_surface *surface;
    const qtri_ink *ink;    /* NULL: opaque, with hard edges */
    qtri_rect bounds;       /* not empty */
    uint32_t stored;        /* the brush's colour as a pixel */
    qtri_channels channels; /* and exactly; only with an ink, */
    uint32_t color_888;     /*   as 0x00RRGGBB as well */
    uint32_t alpha;         /* 1..255 */
} qtri_painter;

/* The part of a glyph to paint: `width` bits of each row from bit `skip` on, highest bit first. */
typedef struct qtri_ink_bits {
    const uint8_t *row;
    int32_t stride;        /* bytes of a row */
    int32_t skip;          /* 0..254 */
    int32_t width, height; /* > 0 */
} qtri_ink_bits;

/* Up to eight bits of a row from bit `at` on, the first in the highest of eight; 0 behind them. */
static inline uint32_t qtri_ink_bits_at(const uint8_t *row, int32_t at, int32_t count)
{
    const uint8_t *byte = row + (at >> 3);
    const uint32_t shift = (uint32_t)at & 7;
    uint32_t value = (uint32_t)*byte << shift;
    if (shift + (uint32_t)count > 8) {
        value |= (uint32_t)byte[1] >> (8 - shift);
    }
    return value & 0xFF & (0xFF00u >> count);
}

struct qtri_ink {
    /* `count` > 0 pixels from `at` on, all of one coverage, 1..255. */
    void (*span)(const qtri_painter *painter, uint8_t *at, int32_t count, uint32_t coverage);
    /* Pixels of one coverage each, 0..255. */
    void (*cover)(const qtri_painter *painter, uint8_t *at, int32_t count, const uint8_t *coverage);
    /* Pixels whose bit is set, fully covered; `at`: the pixel of the first bit. */
    void (*bits)(const qtri_painter *painter, uint8_t *at, const qtri_ink_bits *bits);
    /* A row of a contour, and a rectangle. */
    void (*row)(const qtri_painter *painter, const struct qtri_contour *contour, int32_t row);
    void (*rect)(const qtri_painter *painter, const qtri_area *box);
};

/* Sets a painter up; false: nothing is to be painted. */
bool qtri_painter_begin(qtri_painter *painter, const qtri_surface *surface,
                        const qtri_brush *brush);

/* Paints columns x0..x1-1, clipped, of a row within bounds, all of one coverage, 1..255. */
void qtri_painter_span(const qtri_painter *painter, int32_t row, int32_t x0, int32_t x1,
                       uint32_t coverage);

/* Paints a rectangle of whole pixels, clipped. */
void qtri_painter_rect(const qtri_painter *painter, const qtri_rect *rect);

/* Paints the pixels of a rectangle whose centres lie inside. */
void qtri_hard_rect(const qtri_painter *painter, const qtri_area *box);

/* span, cover and bits of qtri_ink for blended pixels, in any format. */
void qtri_blend_span(const qtri_painter *painter, uint8_t *at, int32_t count, uint32_t coverage);
void qtri_blend_cover(const qtri_painter *painter, uint8_t *at, int32_t count,
                      const uint8_t *coverage);
void qtri_blend_bits(const qtri_painter *painter, uint8_t *to, const qtri_ink_bits *bits);

/* The first pixel whose centre lies at x or behind it. */
static inline int32_t qtri_pixel_from(int32_t x_24p8)
{
    return (x_24p8 + 127) >> 8;
}

static inline int32_t qtri_hold_24p8(int32_t x)
{
    return x < -QTRI_PAINT_MAX_24P8 ? -QTRI_PAINT_MAX_24P8
                                    : (x > QTRI_PAINT_MAX_24P8 ? QTRI_PAINT_MAX_24P8 : x);
}

static inline qtri_point qtri_hold_point(const qtri_point *point)
{
    const qtri_point held = {qtri_hold_24p8(point->x_24p8), qtri_hold_24p8(point->y_24p8)};
    return held;
}

#endif
