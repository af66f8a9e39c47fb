/* SPDX-License-Identifier: MIT */
/*
 * Surfaces: colour and depth in the caller's memory, the whole frame or a band of its rows.
 *
 * Coordinates are those of the frame: row 0 is the top, pixel (x, y) covers [x, x+1) x [y, y+1),
 * its centre lies at +0.5. A surface that holds only some rows ignores what falls outside them, so
 * the same draw calls, replayed band by band, give the pixels of the whole frame exactly.
 */
#ifndef QTRI_SURFACE_H
#define QTRI_SURFACE_H

#include <stddef.h>
#include <stdint.h>

#include "config.h"
#include "error.h"
#include "format.h"
#include "q16.h"

#ifdef __cplusplus
extern "C" {
#endif

#define QTRI_SURFACE_MAX 8192 /* largest width and height of a frame, pixels */

/* In 1/256 pixel of the frame. */
typedef struct qtri_point {
    int32_t x_24p8, y_24p8;
} qtri_point;

/* Half-open: columns x0..x1-1, rows y0..y1-1. Empty when x1 <= x0 or y1 <= y0. */
typedef struct qtri_rect {
    int32_t x0, y0, x1, y1;
} qtri_rect;

/* Colour and depth of some rows of a frame, in memory of the caller. */
typedef struct qtri_surface {
    uint8_t *pixels;       /* first byte of row `first_row`, aligned for the format */
    ptrdiff_t pitch;       /* bytes from a row to the next; negative for bottom-up memory */
    uint16_t *depth;       /* depth of (0, first_row), or NULL: no depth test, no depth written */
    ptrdiff_t depth_pitch; /* stored depths from a row to the next */
    const qtri_format *format; /* NULL: nothing is drawn, pixels are black */
    int32_t width, height;     /* of the frame, 1..QTRI_SURFACE_MAX; more counts as that */
    int32_t first_row, rows;   /* the rows that this memory holds */
    qtri_rect scissor;         /* drawing and clearing stay inside; set to the frame at first */
    const qtri_depth_format *depth_format; /* of what `depth` points at; NULL: linear16 */
} qtri_surface;

/*
 * Memory for `rows` rows of colour and depth, with room to align: a constant expression, with
 * QTRI_RGB565_BYTES and the like, or format->pixels->bytes.
 */
#define QTRI_BAND_BYTES(width, rows, pixel_bytes)                                                  \
    QTRI_BAND_BYTES_DEPTH(width, rows, pixel_bytes, QTRI_DEPTH_LINEAR16_BYTES)

/* With depth of another format: QTRI_DEPTH_FLOAT16_BYTES and the like. */
#define QTRI_BAND_BYTES_DEPTH(width, rows, pixel_bytes, depth_bytes)                               \
    ((size_t)(width) * (size_t)(rows) * ((size_t)(pixel_bytes) + (size_t)(depth_bytes)) + 8u)

/*
 * Lays out rows first_row .. first_row+rows-1 of a width x height frame in `memory` of `bytes`
 * bytes, colour first, then depth. Nothing is cleared. Rows past the frame's end are left out.
 * QTRI_ERROR_SIZE: a side or rows outside 1..QTRI_SURFACE_MAX, or first_row outside the frame.
 * QTRI_ERROR_FORMAT: format is NULL.
 * QTRI_ERROR_MEMORY: memory is NULL, or of fewer bytes than QTRI_BAND_BYTES.
 * After an error the surface is all zero: nothing is drawn on it or cleared, its pixels are black.
 */
enum qtri_error qtri_surface_init(qtri_surface *surface, const qtri_format *format, int32_t width,
                                  int32_t height, int32_t first_row, int32_t rows, void *memory,
                                  size_t bytes);

/*
 * Gives a surface that was just laid out depth of another format, of format.h; NULL: linear16.
 * bytes: of its memory, QTRI_BAND_BYTES_DEPTH. QTRI_ERROR_FORMAT: the surface has no format, or
 * samples (antialias.h); a depth's bytes are not 2, 3 or 4. QTRI_ERROR_MEMORY: too few bytes. After
 * an error the surface is all zero.
 */
enum qtri_error qtri_surface_set_depth(qtri_surface *surface, const qtri_depth_format *format,
                                       size_t bytes);

/* Inside the scissor fills colour, and depth where there is one with the farthest. */
void qtri_surface_clear(const qtri_surface *surface, qtri_rgb color);

/*
 * Fills depth alone, inside the scissor: 0 is the near plane, Q16(1) the far one, and values are
 * held to that: 0 where QTRI_GREATER is to draw, 1 before what is to lie over all that was drawn.
 */
void qtri_surface_clear_depth(const qtri_surface *surface, q16 depth);

/* The pixel's colour widened to 8 bits a channel; black outside the rows held. */
qtri_rgb qtri_surface_pixel(const qtri_surface *surface, int32_t x, int32_t y);

/* The rectangle that drawing may touch: frame, rows held and scissor; 0 0 0 0 when that is empty,
   or there is no format. */
qtri_rect qtri_surface_bounds(const qtri_surface *surface);

#ifdef __cplusplus
}
#endif

#endif
