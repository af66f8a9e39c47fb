/* SPDX-License-Identifier: MIT */
/*
 * Weighted means of stored pixels' colours, in the steps of their format. Internal.
 *
 * A kind of colour (format.h) says in which steps: 5, 6 and 5 bits, 8 bits a channel, or one of 8
 * bits. Formats are decoded and encoded; those whose stored pixels are of the kind qtri_colors_565
 * as they are take quicker ways with the same results.
 */
#ifndef QTRI_FILTER_MIX_H
#define QTRI_FILTER_MIX_H

#include <stdbool.h>

#include "qtri/surface.h"

#include "../bits/bits.h"
#include "../frame/pixel.h"

/* A word with room for 5 bits above each channel of 565: green, red, blue, from the top. */
#define QTRI_LANES_565 0x07E0F81Fu

static inline uint32_t qtri_lanes_565(uint32_t color)
{
    return (color | color << 16) & QTRI_LANES_565;
}

/* RGB565 from channels in their lanes; other bits are ignored. */
static inline uint32_t qtri_packed_565(uint32_t lanes)
{
    lanes &= QTRI_LANES_565;
    return (lanes | lanes >> 16) & 0xFFFF;
}

/*
 * a + (b - a) share / 32 of RGB565 colours, share 0..32, to nearest, halves up. In each lane
 * 32 a + (b - a) share + 16 lies in 0..32 * 63 + 16 < 2^11, and lanes are 10 and 11 bits apart:
 * what a difference borrows from the next lane it gives back.
 */
static inline uint32_t qtri_lerp_565(uint32_t a, uint32_t b, uint32_t share)
{
    const uint32_t p = qtri_lanes_565(a);
    const uint32_t q = qtri_lanes_565(b);
    return qtri_packed_565(((p << 5) + (q - p) * share + 0x02008010u) >> 5);
}

/* The mean of four RGB565 colours, to nearest. Lanes have four channels and 2: below 2^8. */
static inline uint32_t qtri_mean_565(uint32_t a, uint32_t b, uint32_t c, uint32_t d)
{
    const uint32_t sum =
        qtri_lanes_565(a) + qtri_lanes_565(b) + qtri_lanes_565(c) + qtri_lanes_565(d);
    return qtri_packed_565((sum + 0x00401002u) >> 2);
}

/* Whether stored pixels are colours of the kind 565 as they are. */
static inline bool qtri_is_565(const qtri_format *format)
{
    return format->colors == &qtri_colors_565 && format->encode == NULL &&
           format->pixels->bytes == 2;
}

/* A stored pixel as a colour of the format's kind, and back. */
uint32_t qtri_color_of(const qtri_format *format, uint32_t stored);
uint32_t qtri_stored_of(const qtri_format *format, uint32_t color);

/* a + (b - a) share / 32 of two colours of a kind, rounded as by qtri_lerp_565(). */
uint32_t qtri_mix_colors(const qtri_colors *kind, uint32_t a, uint32_t b, uint32_t share);

/* The mean of four stored pixels. */
uint32_t qtri_mean_of(const qtri_format *format, const uint32_t stored[4]);

/* Whether rows of pixels of 16 bits begin with words. */
static inline bool qtri_begins_with_words(const qtri_surface *surface)
{
    return (((uintptr_t)surface->pixels | (uintptr_t)surface->pitch) & 3) == 0;
}

/* Where a colour of a kind has its red, green and blue. */
typedef struct qtri_masks {
    uint32_t mask[3];
    uint8_t shift[3];
} qtri_masks;

const qtri_masks *qtri_masks_of(const qtri_colors *kind);

#endif
