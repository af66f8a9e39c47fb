/* SPDX-License-Identifier: MIT */
/*
 * Textures: texels in memory or computed, how they become colours, and what lies beyond them. A
 * format of texels, one's own too, is a description as those of surfaces are: see format.h.
 */
#ifndef QTRI_TEXTURE_H
#define QTRI_TEXTURE_H

#include <stdbool.h>
#include <stdint.h>

#include "format.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What lies outside of 0..1. Anything else is QTRI_REPEAT. */
typedef enum qtri_wrap {
    QTRI_REPEAT, /* the texture again */
    QTRI_CLAMP   /* its first or last column or row */
} qtri_wrap;

typedef struct qtri_texel_format qtri_texel_format; /* what a texel is: below */
typedef struct qtri_filter qtri_filter;             /* how texels are mixed: below */

/*
 * u = v = 0 is the first texel's first corner, u = 1 and v = 1 one past the last column and row.
 * What an initialiser leaves out is zero: repeated, nearest, without a key.
 *
 * Sides are powers of two: others would take 15 to 25 % more of a pixel's instructions, of every
 * texture. `qtri texture` resamples pictures to such sides, the nearest or those that --size names.
 * Pictures that are painted may have any size: see paint.h.
 *
 * Coordinates are interpolated as they are and clamped at each pixel, so that a clamped texture may
 * lie anywhere on a large triangle. 30 bits hold a triangle's range of coordinates, from the whole
 * repeat below the least: below 16 repeats of 1024 texels in steps of 2^-16 of a texel, below 32768
 * in steps of 1/32.
 *
 * A texel that equals the key is not drawn, neither its colour nor its depth. Compared is what is
 * stored: 16 bits, the low 24 bits of xrgb8888, the number of a palette entry, a gray level, 0 or 1
 * for checker's colours. Bilinear filtering draws the same pixels as without the filter; there the
 * nearest texel also stands in for those of the four that equal the key.
 */
typedef struct qtri_texture {
    const void *texels; /* row by row without gaps; NULL for checker, elsewhere: no texture */
    const qtri_texel_format *format; /* NULL: no texture */
    uint8_t width_log2, height_log2; /* 0..10: sides 1..1024; more is taken as 10 */
    /* checker: fields x fields fields over the texture, colour[(column + row) & 1]. */
    uint16_t fields;
    qtri_rgb color[2];
    qtri_wrap wrap_u, wrap_v;  /* anything but CLAMP repeats */
    const qtri_filter *filter; /* NULL: nearest, the texel that the coordinates lie in */
    /* 256 entries: of palette8 const qtri_rgb *, 8 bits a channel on every surface; of palette565
       const uint16_t *, which RGB565 surfaces store as they are. NULL: no texture. */
    const void *palette;
    bool has_key;
    uint32_t key; /* the stored texel that is not drawn, if has_key */
    /* For filters by levels; NULL, or a null pointer in it: there are none from there on. */
    const void *const *levels;
    uint8_t level_count; /* besides level 0: up to 9 count */
} qtri_texture;

/* Formats of texels
 * ---------------------------------------------------------------------------------------------- */

/* The library's own formats, as pipelines know them (pipeline.h). */
enum {
    QTRI_NO_TEXEL,
    QTRI_TEXEL_RGB565,
    QTRI_TEXEL_XRGB8888,
    QTRI_TEXEL_GRAY8,
    QTRI_TEXEL_PALETTE8,
    QTRI_TEXEL_PALETTE565,
    QTRI_TEXEL_CHECKER,
    QTRI_TEXEL_ARGB8888,
    QTRI_TEXEL_ARGB4444,
    QTRI_TEXEL_ARGB1555,
    QTRI_TEXEL_ALPHA8,
    QTRI_OTHER_TEXEL
};

/* What a stored texel is, and how it is read. */
struct qtri_texel_format {
    const qtri_colors *colors; /* what decode gives: &qtri_colors_565 or &qtri_colors_888 */
    uint32_t key_mask;         /* the bits of a stored texel that are compared with the key */
    /* Whether the texture has what reading needs. Without, it is no texture. */
    bool (*usable)(const qtri_texture *texture);
    /*
     * Numbers of texels, (row << width_log2) + column, become stored texels, in place, and up to
     * three more: there is room for a multiple of four, filled with numbers of texels. NULL in the
     * library's own, which pipelines read by their kind.
     */
    void (*fetch)(uint32_t *texel, const qtri_texture *texture, int32_t count);
    /* Stored texels become colours, in place, and up to three more; NULL: they are. */
    void (*decode)(uint32_t *texel, const qtri_texture *texture, int32_t count);
    uint8_t kind; /* of the library's own; 0: another */
};

extern const qtri_texel_format qtri_texel_rgb565;   /* texels: const uint16_t * */
extern const qtri_texel_format qtri_texel_xrgb8888; /* texels: const uint32_t * */
extern const qtri_texel_format qtri_texel_checker;  /* two colours, no memory: see fields */
extern const qtri_texel_format qtri_texel_gray8;    /* texels: const uint8_t *, white is 255 */

/* texels: const uint8_t *, numbers of entries of the palette. On RGB565 surfaces palette565 is as
   fast as rgb565; a pixel of palette8 takes some 35 instructions more on a Cortex-M0+, 24 on a
   Cortex-M3. */
extern const qtri_texel_format qtri_texel_palette8, qtri_texel_palette565;

/* With alpha, for material.blend and .least_alpha; without either it is not looked at. Filtered,
   alpha is the weighted mean of the texels', which is what least_alpha is compared with, and
   colours are weighted by alpha as well: what is not seen lends no colour to its neighbours. */
extern const qtri_texel_format qtri_texel_argb4444; /* texels: const uint16_t *, a digit each */
extern const qtri_texel_format qtri_texel_argb1555; /* texels: const uint16_t *, alpha 0 or 255 */
extern const qtri_texel_format qtri_texel_argb8888; /* texels: const uint32_t * */
extern const qtri_texel_format qtri_texel_alpha8;   /* texels: const uint8_t *: white with alpha */

/* Filters
 * ---------------------------------------------------------------------------------------------- */

extern const qtri_filter qtri_bilinear; /* the four whose centres lie around them, weighted */
/* Of the texture's levels the one whose texels are as large as pixels: there nearest, or bilinear.
 */
extern const qtri_filter qtri_mipmapped;
extern const qtri_filter qtri_mipmapped_bilinear;

/*
 * Bilinear weights have 8 bits, rounded to nearest, and their sum of colours is rounded once, with
 * the pixel. A weight is off by 1/512 at most, and by what the coordinate is off: the colour by the
 * difference of neighbouring texels times that, in either direction, so by 1 of 255 where black
 * meets white.
 */

/*
 * Levels are the same picture in texels of twice the side each: `qtri texture --mipmaps` makes
 * them. Level 0 is `texels`, level i levels[i - 1], of width_log2 - i and height_log2 - i, or 0.
 * Widths end at two texels: what is beyond is not used. Format, palette, key and wrapping are those
 * of the texture.
 *
 * A pixel's footprint is the longer of two steps on the texture, in texels of level 0: that to the
 * pixel on the right and that to the pixel below, as derivatives have them. The length of a step
 * (du, dv) is the larger of |du| and |dv| and 3/8 of the smaller, which is .97 to 1.07 of it. Drawn
 * is level i where the footprint is 2^(i - 1/2) to 2^(i + 1/2); the first and the last also where
 * it is less and more.
 *
 * It is asked once, at vertex 0, for a triangle that is linear on the screen, or small: less than
 * 120 pixels high, vertices 1 and 2 within 120 of vertex 0 in x, and 1/w within 1/12 of that there.
 * On others it is asked in the middle of every 2 to 64 pixels of a row, along which 1/w varies by
 * 1/8 to both sides at most; of 128 where w does not change along rows, as on floors. Inside of
 * them the level is off by what the footprint varies: 2/5 of a level for what w does, and on planes
 * whose horizon is r rows away, for pixels h from the middle, by h / r of the step right in the
 * step down; rounding adds .01. On slivers of less than a pixel's height it may be any. No band or
 * scissor changes a level.
 */

#ifdef __cplusplus
}
#endif

#endif
