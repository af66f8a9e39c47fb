/* SPDX-License-Identifier: MIT */
/*
 * Formats of surfaces: what a pixel is, as constant data.
 *
 * A format is chosen by the address of its description, &qtri_rgb565. What an application does not
 * name is not linked, and a format of one's own is such a description in one's own file:
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

/* For 1, 2, 3 and 4 bytes. */
extern const qtri_pixels qtri_pixels_8, qtri_pixels_16, qtri_pixels_24, qtri_pixels_32;

/* Several samples a pixel; see antialias.h. */
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

/* What a stored pixel is: its memory, and what its bits mean. */
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
 * alone: material.h says what is within which). Pictures that are blended are converted first.
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

/* ---- Depth ---- */

/*
 * Formats of depth. Depth is window z, 0 at the near plane and 1 at the far one. A surface stores
 * it as 16 bits, linear in the window, unless it is laid out with another format; what an
 * application does not name is not linked.
 *
 *     static uint8_t memory[QTRI_FRAME_BYTES_DEPTH(320, 16, QTRI_RGB565_BYTES,
 *                                                  QTRI_DEPTH_FLOAT16_BYTES)];
 *     qtri_frame_init(&frame, &qtri_rgb565, 320, 240, 16, memory, sizeof memory);
 *     qtri_frame_set_depth(&frame, &qtri_depth_float16);
 *
 * Which one. Move the near plane away as far as the scene allows, which costs nothing: in
 * perspective window z has nearly all its steps close to it. Faces can be told apart at a distance
 * d that are from each other
 *
 *   linear16   d^2 / (65536 near): the fastest by far, right where far / near is some hundred, and
 *              without perspective
 *   float16    d / 4096: for wide views, in the same memory; without perspective its steps are
 *              wasted at the far plane
 *   linear24   d^2 / (2^24 near), in 3 bytes
 *   linear32   half of that, where vertices' own depths end; saves instructions for the fourth byte
 *
 * Measured, near plane .1, far plane 1000: sheets of paper on each other, 30 away, of whose pixels
 * so many show the wrong one; and of a knot that is .1 units wide at the same distance
 * (host/scenes/12-depth-*.scene, where the reference in double precision rounds .01 and .05 %
 * otherwise; tests/test_scene_depth.c has more, with linear32).
 *
 *     apart        .1       .04      .01      .003     .001     knot
 *     linear16     .82 %    45 %     74 %     80 %     82 %     16 %
 *     float16      .01      .01      .01      8.4      57       .05
 *     linear24     .01      .01      .01      .01      .01      .05
 *
 * On RGB565 with "less" these formats bring pipelines of their own (pipeline.h), for one colour,
 * light, colours, and RGB565 texels: some 1.5 KB each at -Os. Surfaces of four samples
 * (antialias.h) have linear16 alone. A format of one's own is such a description in one's own file.
 */

/* What fills and reads memory of depths that are not linear16. */
typedef struct qtri_depth_ops qtri_depth_ops;
struct qtri_effect;
extern const qtri_depth_ops qtri_depth_words;

/* The library's own formats, as pipelines know them (pipeline.h). */
enum { QTRI_NO_DEPTH, QTRI_LINEAR16, QTRI_FLOAT16, QTRI_LINEAR24, QTRI_LINEAR32, QTRI_OTHER_DEPTH };

/*
 * Until it is stored, depth is 16.16: window z times 65535, 0..0xFFFF0000. A stored depth is an
 * integer in the machine's byte order; of three bytes the lowest is first. Stored depths must
 * compare as depths do: a farther one is never less.
 */
typedef struct qtri_depth_format {
    uint8_t bytes;             /* of a stored depth: 2, 3 or 4 */
    const qtri_depth_ops *ops; /* &qtri_depth_words; NULL: it is linear16 */
    /* Depths to stored ones and back, in place; `count` is 1..32. */
    void (*encode)(uint32_t *depth, int32_t count);
    void (*decode)(uint32_t *depth, int32_t count);
    uint8_t kind;                     /* of the library's own; 0: another */
    const struct qtri_effect *effect; /* what draws it; internal. NULL: the generic pipeline */
} qtri_depth_format;

extern const qtri_depth_format qtri_depth_linear16; /* 65535 steps; where none is named */
extern const qtri_depth_format qtri_depth_float16;  /* 1 - z: 4 bits exponent, 12 bits mantissa */
extern const qtri_depth_format qtri_depth_linear24; /* steps of 1/256 of those of linear16 */
extern const qtri_depth_format qtri_depth_linear32; /* steps of 1/65536 of them */

/* Bytes of a stored depth, for memory of constant size. */
enum {
    QTRI_DEPTH_LINEAR16_BYTES = 2,
    QTRI_DEPTH_FLOAT16_BYTES = 2,
    QTRI_DEPTH_LINEAR24_BYTES = 3,
    QTRI_DEPTH_LINEAR32_BYTES = 4
};

#ifdef __cplusplus
}
#endif

#endif
