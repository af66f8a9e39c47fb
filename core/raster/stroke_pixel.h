/* SPDX-License-Identifier: MIT */
/*
 * What becomes of a pixel that a stroke covers. Internal.
 */
#ifndef QTRI_RASTER_STROKE_PIXEL_H
#define QTRI_RASTER_STROKE_PIXEL_H

#include "../frame/colors.h"
#include "stroke.h"

/* 1 if a depth passes the test, whose three bits are a stroker's `passing`; else 0. */
static inline uint32_t qtri_stroke_passes(uint32_t passing, uint32_t depth, uint32_t stored)
{
    const uint32_t which = depth < stored ? 0 : (depth == stored ? 1 : 2);
    return passing >> which & 1;
}

/* cover alpha / 255 in Q16: 32897 / 2^23 is 1 / 255 within 2^-30. */
static inline int32_t qtri_stroke_share(const qtri_stroker *stroker, int32_t cover)
{
    if (stroker->alpha == 255) {
        return cover >> 1;
    }
    return (int32_t)((uint32_t)(cover >> 2) * ((stroker->alpha * 32897u) >> 8) >> 14);
}

/* A colour, or what a share of it, 0..2^16, makes of a stored pixel, before it is encoded. */
static inline uint32_t qtri_stroke_word(const qtri_format *format, const int32_t color_8p16[3],
                                        const uint8_t *pixel, int32_t share_q16)
{
    int32_t color[3] = {color_8p16[0], color_8p16[1], color_8p16[2]};
    if (share_q16 < 65536) {
        const uint32_t stored = format->decode(format->pixels->load(pixel));
        for (int i = 0; i < 3; i++) {
            const int32_t below = (int32_t)(stored >> (16 - 8 * i) & 0xFFu) << 16;
            /* |.| <= 255 2^7 2^16 < 2^31 */
            color[i] = below + ((((color[i] - below) >> 9) * share_q16) >> 7);
        }
    }
    const qtri_channels channels = qtri_channels_from_color(format->colors, color);
    return format->colors->pack(channels.c);
}

#endif
