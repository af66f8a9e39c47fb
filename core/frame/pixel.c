/* SPDX-License-Identifier: MIT */
#include "pixel.h"

#include "../bits/bits.h"

static int32_t scaled(uint8_t channel, uint32_t ratio_q30)
{
    return (int32_t)qtri_channel_scaled(channel, ratio_q30);
}

qtri_channels qtri_channels_from_rgb(const qtri_colors *colors, qtri_rgb color)
{
    const uint32_t *ratio = colors->ratio_q30;
    qtri_channels result = {
        {scaled(color.r, ratio[0]), scaled(color.g, ratio[1]), scaled(color.b, ratio[2])}};
    return result;
}

uint32_t qtri_pixel_from_rgb(const qtri_format *format, qtri_rgb color)
{
    qtri_channels channels = qtri_channels_from_rgb(format->colors, color);
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
