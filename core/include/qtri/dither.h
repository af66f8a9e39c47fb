/* SPDX-License-Identifier: MIT */
/*
 * Dithering: from the pixels of a surface to the few levels of gray or colours that a display can
 * show. Levels run from 0, black, to max_level, white: 1 for an OLED or e-paper with one bit a
 * pixel, 15 for four bits. A gray that a level equals comes out exactly.
 *
 * Ordered dither compares with thresholds that repeat over the screen (Bayer 1973). A pixel depends
 * on its own gray and its coordinates in the frame alone: bands and rectangles have no seams, and
 * what stands still does not flicker. Error diffusion (Floyd and Steinberg 1976) is finer and suits
 * pictures that are sent whole and seldom: e-paper.
 */
#ifndef QTRI_DITHER_H
#define QTRI_DITHER_H

#include <stddef.h>
#include <stdint.h>

#include "surface.h"

#ifdef __cplusplus
extern "C" {
#endif

/* How gray becomes a few levels. */
typedef enum qtri_dither {
    QTRI_DITHER_NEAREST, /* the nearest level; of two, the threshold lies between 127 and 128 */
    QTRI_DITHER_BAYER4,  /* 4 x 4 pixels: 16 steps from a level to the next */
    QTRI_DITHER_BAYER8   /* 8 x 8 pixels: 64 steps */
} qtri_dither;

/*
 * Luma of pixels (x, y) .. (x + count - 1, y), .299 R + .587 G + .114 B of 255, rounded once; what
 * is stored in GRAY8. Black where the surface holds no pixel; any x, y. count <= 0: none.
 */
void qtri_surface_gray(const qtri_surface *surface, int32_t x, int32_t y, int32_t count,
                       uint8_t *gray);

/*
 * Levels 0..max_level of the pixels (x, y) .. (x + count - 1, y) of the frame; any x, y, and what
 * is no qtri_dither is NEAREST. The mean over a field of 4 x 4 or 8 x 8 pixels of one gray is
 * within 1/32 or 1/128 of gray * max_level / 255. `level` may be `gray`.
 */
void qtri_dither_row(qtri_dither dither, uint8_t max_level, int32_t x, int32_t y,
                     const uint8_t *gray, int32_t count, uint8_t *level);

/*
 * Colours 0x00RRGGBB of pixels (x, y) .. (x + count - 1, y) as RGB565: smooth shading without
 * bands. Any x, y; what is no qtri_dither is NEAREST, and BAYER4 and BAYER8 have thresholds as
 * above, one for the three channels. Colours that RGB565 has come out exactly, black and white
 * among them; the mean of a channel over a field is within .78 of 255.
 */
void qtri_dither_row_565(qtri_dither dither, int32_t x, int32_t y, const uint32_t *rgb,
                         int32_t count, uint16_t *pixels);

/* What error diffusion carries from pixel to pixel and row to row: 2 bytes a column. */
typedef struct qtri_diffusion {
    int16_t *error; /* of the row to come, 1/max_level of a gray */
    int32_t width;
    int32_t next_x, next_y;       /* the pixel expected next */
    int32_t right, below, corner; /* errors on their way to this row and the next */
} qtri_diffusion;

/*
 * `error` has `count` elements, width of them are used.
 * QTRI_ERROR_SIZE: width outside 1..QTRI_SURFACE_MAX. QTRI_ERROR_MEMORY: count < width.
 */
enum qtri_error qtri_diffusion_init(qtri_diffusion *diffusion, int32_t width, int16_t *error,
                                    size_t count);

/*
 * Levels of the pixels (x, y) .. (x + count - 1, y). Pixels come in reading order, in pieces of any
 * length: row 0 from the left, row 1, ... to any row. A piece out of order begins a new picture,
 * without errors; so does row 0. Columns outside 0..width-1 are not written. `level` may be `gray`.
 */
void qtri_diffuse_row(qtri_diffusion *diffusion, uint8_t max_level, int32_t x, int32_t y,
                      const uint8_t *gray, int32_t count, uint8_t *level);

#ifdef __cplusplus
}
#endif

#endif
