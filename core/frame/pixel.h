/* SPDX-License-Identifier: MIT */
/*
 * From colours of 8 bits to channels in units of the target's own steps, and on to stored pixels.
 * Internal; see colors.h.
 */
#ifndef QTRI_FRAME_PIXEL_H
#define QTRI_FRAME_PIXEL_H

#include <stdbool.h>

#include "qtri/surface.h"

#include "../bits/bits.h"
#include "colors.h"

typedef struct qtri_channels {
    int32_t c[3]; /* red green blue, n.16 */
} qtri_channels;

/*
 * A channel of 0..255.0, n.16, in units of which there are ratio_q30 2^-30 to one, n.16, rounded
 * down: with 8 of its bits after the point, so that no product is longer than 32 bits. It is off by
 * 1/512 of a step of 255; of colours of 8 bits by nothing.
 */
static inline uint32_t qtri_channel_scaled(uint32_t channel_8p16, uint32_t ratio_q30)
{
    const uint32_t q8 = (channel_8p16 + 128) >> 8; /* <= 65280 */
#if QTRI_LONG_MULTIPLY
    return (uint32_t)(((uint64_t)(q8 << 10) * ratio_q30) >> 32);
#else
    const uint32_t low = q8 * (ratio_q30 & (((uint32_t)1 << 14) - 1)); /* < 2^30 */
    return (q8 * (ratio_q30 >> 14) + (low >> 14)) >> 8;                /* <= 65280 2^16 */
#endif
}

/* color_8p16 (0..255.0) in units of these colours, n.16. */
qtri_channels qtri_channels_from_color(const qtri_colors *colors, const int32_t color_8p16[3]);

/* An 8-bit colour as a stored pixel. */
uint32_t qtri_pixel_from_rgb(const qtri_format *format, qtri_rgb color);

/* 0x00RRGGBB, whatever its high byte. */
static inline qtri_rgb qtri_rgb_from_888(uint32_t color)
{
    qtri_rgb rgb = {(uint8_t)(color >> 16), (uint8_t)(color >> 8), (uint8_t)color};
    return rgb;
}

#endif
