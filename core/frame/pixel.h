/*
 * Pixel formats: from channels in units of the target's own steps to stored pixels. Internal.
 *
 * A channel is interpolated in target units: 0..31 for RGB565's red, 0..255 for XRGB8888, the
 * luma-weighted share of 0..255 for GRAY8, each with 16 fraction bits. So a colour is rounded
 * exactly once, when it is stored, and flat, smooth and textured pixels share one rule.
 */
#ifndef QTRI_FRAME_PIXEL_H
#define QTRI_FRAME_PIXEL_H

#include <stdbool.h>

#include "qtri/surface.h"

typedef struct qtri_channels {
    int32_t c[3]; /* red green blue, n.16 */
} qtri_channels;

/* White in units of GRAY8: .299 .587 .114 of 255, n.16; the sum is 255 << 16 exactly. */
#define QTRI_GRAY_RED   4996792
#define QTRI_GRAY_GREEN 9809756
#define QTRI_GRAY_BLUE  1905132

/* Whether the library can draw on it. Unknown formats count as GRAY8. */
static inline bool qtri_format_is_built(qtri_format format)
{
    return (QTRI_WITH_RGB565 && format == QTRI_RGB565) ||
           (QTRI_WITH_XRGB8888 && format == QTRI_XRGB8888) ||
           (QTRI_WITH_GRAY8 && format != QTRI_RGB565 && format != QTRI_XRGB8888);
}

/* One of the formats that the library is built with, which this is: known to the compiler if there
   is a single one. Nothing gets here for others, as their bounds are empty. */
static inline qtri_format qtri_format_built(qtri_format format)
{
    if (QTRI_WITH_RGB565 && QTRI_WITH_XRGB8888 && QTRI_WITH_GRAY8) {
        return format;
    }
    if (QTRI_WITH_RGB565 && (format == QTRI_RGB565 || !(QTRI_WITH_XRGB8888 || QTRI_WITH_GRAY8))) {
        return QTRI_RGB565;
    }
    return QTRI_WITH_XRGB8888 && (format == QTRI_XRGB8888 || !QTRI_WITH_GRAY8) ? QTRI_XRGB8888
                                                                               : QTRI_GRAY8;
}

static inline qtri_format qtri_format_of(const qtri_surface *surface)
{
    return qtri_format_built(surface->format);
}

static inline uint32_t qtri_channel_round(int32_t c)
{
    return (uint32_t)(c + 0x8000) >> 16;
}

static inline uint32_t qtri_pixel_pack(qtri_format format, const qtri_channels *color)
{
    const int32_t *c = color->c;
    switch (qtri_format_built(format)) {
    case QTRI_RGB565:
        return qtri_channel_round(c[0]) << 11 | qtri_channel_round(c[1]) << 5 |
               qtri_channel_round(c[2]);
    case QTRI_XRGB8888:
        return qtri_channel_round(c[0]) << 16 | qtri_channel_round(c[1]) << 8 |
               qtri_channel_round(c[2]);
    default:
        return qtri_channel_round(c[0] + c[1] + c[2]);
    }
}

static inline void qtri_pixel_store(qtri_format format, uint8_t *row, int32_t x, uint32_t pixel)
{
    switch (qtri_format_built(format)) {
    case QTRI_RGB565:
        ((uint16_t *)(void *)row)[x] = (uint16_t)pixel;
        break;
    case QTRI_XRGB8888:
        ((uint32_t *)(void *)row)[x] = pixel;
        break;
    default:
        row[x] = (uint8_t)pixel;
        break;
    }
}

/* color_8p16 (0..255.0) in units of the format, n.16, to nearest. */
qtri_channels qtri_channels_from_color(qtri_format format, const int32_t color_8p16[3]);

/* An 8-bit colour as a stored pixel. */
uint32_t qtri_pixel_from_rgb(qtri_format format, qtri_rgb color);

/* Stored pixels and texels as 8-bit colours: 31 and 63 become 255, rounded between. */
qtri_rgb qtri_rgb_from_565(uint32_t pixel);
qtri_rgb qtri_rgb_from_8888(uint32_t pixel);
qtri_rgb qtri_pixel_widen(qtri_format format, const uint8_t *row, int32_t x);

#endif
