/* SPDX-License-Identifier: MIT */
/*
 * From colours of 8 bits to channels in units of the target's own steps, and on to stored pixels.
 * Internal.
 *
 * A channel is interpolated in units of the kind: 0..31 for red of 565, 0..255 for 888, the
 * luma-weighted share of 0..255 for gray, each with 16 fraction bits. So a colour is rounded
 * exactly once, when it is packed, and flat, smooth and textured pixels share one rule.
 */
#ifndef QTRI_FRAME_PIXEL_H
#define QTRI_FRAME_PIXEL_H

#include <stdbool.h>

#include "qtri/surface.h"

#include "../bits/bits.h"

/* ---- Kinds of colour ---- */

/* White in gray's units: .299 .587 .114 of 255, n.16; the sum is 255 << 16 exactly. */
#define QTRI_GRAY_RED   4996792
#define QTRI_GRAY_GREEN 9809756
#define QTRI_GRAY_BLUE  1905132

struct qtri_colors {
    uint32_t ratio_q30[3];                      /* units of 1/255, rounded */
    bool single;                                /* only the sum of the channels counts */
    uint8_t red, green;                         /* where they begin in a colour; blue: at bit 0 */
    uint32_t (*pack)(const int32_t channel[3]); /* rounded, from n.16 */
};

static inline uint32_t qtri_channel_round(int32_t c)
{
    return (uint32_t)(c + 0x8000) >> 16;
}

static inline uint32_t qtri_pack_565(const int32_t c[3])
{
    return qtri_channel_round(c[0]) << 11 | qtri_channel_round(c[1]) << 5 |
           qtri_channel_round(c[2]);
}

static inline uint32_t qtri_pack_888(const int32_t c[3])
{
    return qtri_channel_round(c[0]) << 16 | qtri_channel_round(c[1]) << 8 |
           qtri_channel_round(c[2]);
}

static inline uint32_t qtri_pack_gray(const int32_t c[3])
{
    return qtri_channel_round(c[0] + c[1] + c[2]);
}

/* ---- Channels ---- */

typedef struct qtri_channels {
    int32_t c[3]; /* red green blue, n.16 */
} qtri_channels;

/* A channel of 0..255 in units of which there are ratio_q30 2^-30 to one, n.16, rounded down. */
static inline uint32_t qtri_channel_scaled(uint32_t channel, uint32_t ratio_q30)
{
#if QTRI_LONG_MULTIPLY
    return (uint32_t)(((uint64_t)(channel << 18) * ratio_q30) >> 32);
#else
    const uint32_t q8 = channel << 8;
    const uint32_t low = q8 * (ratio_q30 & (((uint32_t)1 << 14) - 1)); /* < 2^30 */
    return (q8 * (ratio_q30 >> 14) + (low >> 14)) >> 8;                /* <= 65280 2^16 */
#endif
}

/* A colour in units of these colours, n.16. */
qtri_channels qtri_channels_from_rgb(const qtri_colors *colors, qtri_rgb color);

/* An 8-bit colour as a stored pixel. */
uint32_t qtri_pixel_from_rgb(const qtri_format *format, qtri_rgb color);

/* ---- Stored pixels ---- */

/* Where a pixel of a row that the surface holds is stored. */
static inline uint8_t *qtri_surface_at(const qtri_surface *surface, int32_t x, int32_t row)
{
    return surface->pixels + (ptrdiff_t)(row - surface->first_row) * surface->pitch +
           (ptrdiff_t)surface->format->pixels->bytes * x;
}

/* A pixel of 1 to 4 bytes. */
QTRI_INLINE uint32_t qtri_stored_get(int32_t bytes, const uint8_t *at)
{
    switch (bytes) {
    case 1:
        return at[0];
    case 2:
        return *(const uint16_t *)(const void *)at;
    case 3:
        return at[0] | (uint32_t)at[1] << 8 | (uint32_t)at[2] << 16;
    default:
        return *(const uint32_t *)(const void *)at;
    }
}

QTRI_INLINE void qtri_stored_put(int32_t bytes, uint8_t *at, uint32_t stored)
{
    switch (bytes) {
    case 1:
        at[0] = (uint8_t)stored;
        break;
    case 2:
        *(uint16_t *)(void *)at = (uint16_t)stored;
        break;
    case 3:
        at[0] = (uint8_t)stored;
        at[1] = (uint8_t)(stored >> 8);
        at[2] = (uint8_t)(stored >> 16);
        break;
    default:
        *(uint32_t *)(void *)at = stored;
        break;
    }
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
