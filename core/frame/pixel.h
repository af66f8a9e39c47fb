/* SPDX-License-Identifier: MIT */
/*
 * Colours of 8 bits as channels in steps of a surface's format, stored pixels, and memory of these
 * filled and copied. Internal.
 *
 * A channel is interpolated in units of the kind: 0..31 for red of 565, 0..255 for 888, the
 * luma-weighted share of 0..255 for gray, each with 16 fraction bits. So a colour is rounded
 * exactly once, when it is packed, and flat, smooth and textured pixels share one rule.
 */
#ifndef QTRI_FRAME_PIXEL_H
#define QTRI_FRAME_PIXEL_H

#include <stdbool.h>

#include "qtri/body/color.h"
#include "qtri/surface.h"

#include "../bits/bits.h"

/* ---- Kinds of colour ---- */

struct qtri_colors {
    uint32_t ratio_q30[3];                      /* units of 1/255, rounded */
    bool single;                                /* only the sum of the channels counts */
    uint8_t red, green;                         /* their lowest bits in a colour; blue has bit 0 */
    uint32_t (*pack)(const int32_t channel[3]); /* rounded, from n.16 */
};

/* ---- Channels ---- */

typedef struct qtri_channels {
    int32_t c[3]; /* red green blue, n.16 */
} qtri_channels;

/* An 8-bit colour in units of these colours. */
qtri_channels qtri_channels_from_color(const qtri_colors *colors, qtri_rgb color);

/* An 8-bit colour as a stored pixel. */
uint32_t qtri_pixel_from_rgb(const qtri_format *format, qtri_rgb color);

/* ---- Stored pixels ---- */

/* A word that may alias other types: two pixels of 16 bits, for one. */
#ifdef __GNUC__
typedef uint32_t __attribute__((__may_alias__)) qtri_word;
#else
typedef uint32_t qtri_word;
#endif

static inline bool qtri_rect_is_empty(const qtri_rect *rect)
{
    return rect->x0 >= rect->x1 || rect->y0 >= rect->y1;
}

/* The address of a pixel, in a row that the surface holds. */
static inline uint8_t *qtri_surface_at(const qtri_surface *surface, int32_t x, int32_t row)
{
    return surface->pixels + (ptrdiff_t)(row - surface->first_row) * surface->pitch +
           (ptrdiff_t)surface->format->pixels->bytes * x;
}

/*
 * The cases of a switch over a pixel's 1 to 4 bytes: calls `function` with them, constants that the
 * compiler makes a loop each of.
 */
#define QTRI_BYTES_CASES(function, ...)                                                            \
    case 1:                                                                                        \
        function(1, __VA_ARGS__);                                                                  \
        break;                                                                                     \
    case 2:                                                                                        \
        function(2, __VA_ARGS__);                                                                  \
        break;                                                                                     \
    case 3:                                                                                        \
        function(3, __VA_ARGS__);                                                                  \
        break;                                                                                     \
    default:                                                                                       \
        function(4, __VA_ARGS__);                                                                  \
        break

/* ---- Words that formats encode and decode ---- */

/* `encode` of qtri_rgb565_swapped and of qtri_rgb888. */
void qtri_encode_rgb565_swapped(uint32_t *color, int32_t count);
void qtri_encode_rgb888(uint32_t *color, int32_t count);

/*
 * Replaces each x of `count` words by `result`, for encode and decode of formats; `words` is a
 * variable that moves on. Up to three words more are changed, so that groups of four need no
 * remainder.
 */
#define QTRI_EACH_WORD(words, count, x, result)                                                    \
    for (const uint32_t *end = (words) + (count); (words) < end; (words) += QTRI_WORDS_AT_ONCE) {  \
        QTRI_BODY_UNROLL                                                                           \
        for (int i = 0; i < QTRI_WORDS_AT_ONCE; i++) {                                             \
            const uint32_t x = (words)[i];                                                         \
            (words)[i] = (result);                                                                 \
            QTRI_BODY_BARRIER(words);                                                              \
        }                                                                                          \
    }
enum { QTRI_WORDS_AT_ONCE = QTRI_BODY_IS_SMALL ? 1 : 4 };

/* ---- Memory filled with one value, and copied ---- */

/*
 * Fills `rows` rows of `bytes` > 0 bytes with a word `value` as it lies in memory, at whichever
 * byte a row begins. Rows without gaps are one row.
 */
void qtri_fill_words(uint8_t *first, ptrdiff_t pitch, size_t bytes, int32_t rows, uint32_t value);

/* Copies bytes that do not overlap, in the widest units in which both sides can be aligned. */
void qtri_copy(uint8_t *to, const uint8_t *from, size_t bytes);

/* Fills a rectangle, which is not empty and lies in qtri_surface_bounds, with a stored pixel. */
void qtri_fill_rect(const qtri_surface *surface, const qtri_rect *rect, uint32_t stored);

#endif
