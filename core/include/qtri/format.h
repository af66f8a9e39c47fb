/* SPDX-License-Identifier: MIT */
/*
 * Formats of surfaces: what a pixel is, as constant data.
 *
 * A format is chosen by the address of its description, &qtri_rgb565. What an application does not
 * name is not linked, and a format of one's own is such a description in one's own file: how many
 * bytes a pixel has, which kind of colour it is made of, and what turns colours into stored pixels
 * and back.
 *
 *     static void encode(uint32_t *color, int32_t count) { ... each color[i] in place ... }
 *     static uint32_t decode(uint32_t stored) { ... 0x00RRGGBB ... }
 *     const qtri_format rgb444 = {&qtri_pixels_16, &qtri_colors_888, encode, decode, NULL, 0};
 */
#ifndef QTRI_FORMAT_H
#define QTRI_FORMAT_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* 8 bits a channel. */
typedef struct qtri_rgb {
    uint8_t r, g, b;
} qtri_rgb;

/*
 * Kinds of colour, as words: what formats encode, and what texels are decoded to.
 *
 *     qtri_colors_565    rrrrrggggggbbbbb in the low 16 bits
 *     qtri_colors_888    0x00RRGGBB
 *     qtri_colors_gray   0..255, luma .299 R + .587 G + .114 B
 */
typedef struct qtri_colors qtri_colors;
extern const qtri_colors qtri_colors_565, qtri_colors_888, qtri_colors_gray;

/*
 * Memory of pixels of 1, 2, 3 and 4 bytes. A stored pixel is an integer: uint8_t, uint16_t and
 * uint32_t in the machine's byte order; of three bytes the lowest is first.
 *
 * A mask has a bit for each of `count` (1..32) pixels, the lowest for the last; only those with a
 * bit are written.
 */
typedef struct qtri_pixels {
    uint8_t bytes; /* of a pixel */
    uint32_t (*load)(const uint8_t *pixel);
    void (*fill)(uint8_t *pixel, uint32_t stored, uint32_t mask, int32_t count);
    void (*store)(uint8_t *pixel, const uint32_t *stored, uint32_t mask, int32_t count);
} qtri_pixels;
extern const qtri_pixels qtri_pixels_8, qtri_pixels_16, qtri_pixels_24, qtri_pixels_32;

/* Several samples a pixel; see samples.h. */
typedef struct qtri_sampling qtri_sampling;

/* The library's own formats, as pipelines know them (pipeline.h). */
enum {
    QTRI_OTHER_FORMAT,
    QTRI_RGB565,
    QTRI_RGB565_SWAPPED,
    QTRI_RGB565_EXACT,
    QTRI_RGB888,
    QTRI_BGR888,
    QTRI_XRGB8888,
    QTRI_GRAY8,
    QTRI_DEPTH_ONLY
};

typedef struct qtri_format {
    const qtri_pixels *pixels;
    const qtri_colors *colors; /* the kind that encode takes */
    /* Colours to stored pixels, in place, and up to three more: there is room for a multiple of
       four. NULL: they are the same. */
    void (*encode)(uint32_t *color, int32_t count);
    /* A stored pixel as 0x00RRGGBB, full channels being 255. */
    uint32_t (*decode)(uint32_t stored);
    const qtri_sampling *samples; /* NULL: one a pixel */
    uint8_t kind;                 /* of the library's own formats; 0: another */
} qtri_format;

extern const qtri_format qtri_rgb565;         /* uint16_t, red in the high bits */
extern const qtri_format qtri_rgb565_swapped; /* its bytes exchanged, as displays on SPI want it */
/*
 * Stored as rgb565, but colours have 8 bits until then: one that light, texels, fog and blends make
 * together is rounded once, within 3/4 of a step where &qtri_rgb565 reaches 1 1/4 (not in fog
 * alone: blend.h says what is within which). Pictures that are blended are converted first.
 */
extern const qtri_format qtri_rgb565_exact;
extern const qtri_format qtri_rgb888;   /* three bytes: red, green, blue */
extern const qtri_format qtri_bgr888;   /* three bytes: blue, green, red */
extern const qtri_format qtri_xrgb8888; /* uint32_t, 0x00RRGGBB */
extern const qtri_format qtri_gray8;    /* uint8_t, luma .299 R + .587 G + .114 B */

/* Pixels that are not there: a surface of this format takes depth and leaves its memory alone. */
extern const qtri_format qtri_depth_only;

/*
 * What a stored pixel means, for descriptions of one's own: where `decode` is one of these, copies
 * and conversions know the format by it. bgr888 has that of xrgb8888.
 */
uint32_t qtri_decode_rgb565(uint32_t stored);
uint32_t qtri_decode_rgb565_swapped(uint32_t stored);
uint32_t qtri_decode_rgb888(uint32_t stored);
uint32_t qtri_decode_xrgb8888(uint32_t stored);
uint32_t qtri_decode_gray8(uint32_t stored);

/* Bytes of a pixel, for memory of constant size: QTRI_BAND_BYTES(320, 16, QTRI_RGB565_BYTES). */
enum {
    QTRI_GRAY8_BYTES = 1,
    QTRI_RGB565_BYTES = 2,
    QTRI_RGB888_BYTES = 3,
    QTRI_XRGB8888_BYTES = 4
};

#ifdef __cplusplus
}
#endif

#endif
