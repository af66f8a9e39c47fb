/* SPDX-License-Identifier: MIT */
#include "pixel.h"

#include "../bits/bits.h"

static int32_t scaled(int32_t color_8p16, uint32_t ratio_q30)
{
    const uint32_t white = (uint32_t)255 << 16;
    uint32_t c = (uint32_t)color_8p16;
    if (c > white) {
        QTRI_RARELY();
        c = color_8p16 < 0 ? 0 : white;
    }
    return (int32_t)qtri_channel_scaled(c, ratio_q30);
}

qtri_channels qtri_channels_from_color(const qtri_colors *colors, const int32_t color_8p16[3])
{
    const uint32_t *ratio = colors->ratio_q30;
    qtri_channels result = {{scaled(color_8p16[0], ratio[0]), scaled(color_8p16[1], ratio[1]),
                             scaled(color_8p16[2], ratio[2])}};
    return result;
}

uint32_t qtri_pixel_from_rgb(const qtri_format *format, qtri_rgb color)
{
    int32_t color_8p16[3] = {(int32_t)color.r << 16, (int32_t)color.g << 16,
                             (int32_t)color.b << 16};
    qtri_channels channels = qtri_channels_from_color(format->colors, color_8p16);
    uint32_t pixel[4] = {format->colors->pack(channels.c)};
    if (format->encode != NULL) {
        format->encode(pixel, 1);
    }
    return pixel[0];
}

/* ---- Kinds of colour ---- */

/* What white is of this channel, n.16, / (255 << 16) in Q30, rounded: times a colour of 24 bits,
   off by less than 2^-6 units. */
#define RATIO_Q30(white)                                                                           \
    ((uint32_t)((((uint64_t)(white) << 30) + ((uint32_t)255 << 15)) / ((uint32_t)255 << 16)))

#define RATIOS(red, green, blue)                                                                   \
    {                                                                                              \
        RATIO_Q30(red), RATIO_Q30(green), RATIO_Q30(blue)                                          \
    }

static uint32_t pack_565(const int32_t channel[3])
{
    return qtri_pack_565(channel);
}

static uint32_t pack_888(const int32_t channel[3])
{
    return qtri_pack_888(channel);
}

static uint32_t pack_gray(const int32_t channel[3])
{
    return qtri_pack_gray(channel);
}

const qtri_colors qtri_colors_565 = {
    RATIOS((int32_t)31 << 16, (int32_t)63 << 16, (int32_t)31 << 16), false, 11, 5, pack_565};

const qtri_colors qtri_colors_888 = {
    RATIOS((int32_t)255 << 16, (int32_t)255 << 16, (int32_t)255 << 16), false, 16, 8, pack_888};

const qtri_colors qtri_colors_gray = {RATIOS(QTRI_GRAY_RED, QTRI_GRAY_GREEN, QTRI_GRAY_BLUE), true,
                                      0, 0, pack_gray};
