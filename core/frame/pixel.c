/* SPDX-License-Identifier: MIT */
#include "pixel.h"

#include "../bits/bits.h"

/*
 * channel ratio_q30 2^-30 in n.16, rounded down, channel of 8 bits: by halves of the ratio, so that
 * no product is longer than 32 bits.
 */
static int32_t scaled(uint32_t channel, uint32_t ratio_q30)
{
    return (int32_t)(channel * (ratio_q30 >> 14) + (channel * (ratio_q30 & 0x3FFF) >> 14));
}

qtri_channels qtri_channels_from_color(const qtri_colors *colors, qtri_rgb color)
{
    const uint32_t *ratio = colors->ratio_q30;
    const qtri_channels result = {
        {scaled(color.r, ratio[0]), scaled(color.g, ratio[1]), scaled(color.b, ratio[2])}};
    return result;
}

uint32_t qtri_pixel_from_rgb(const qtri_format *format, qtri_rgb color)
{
    const qtri_channels channels = qtri_channels_from_color(format->colors, color);
    uint32_t pixel[4] = {format->colors->pack(channels.c)};
    if (format->encode != NULL) {
        format->encode(pixel, 1);
    }
    return pixel[0];
}

/* ---- Kinds of colour ---- */

/* white / (255 << 16) in Q30, rounded: times a channel of 24 bits, off by less than 2^-6 units. */
#define RATIO_Q30(white)                                                                           \
    ((uint32_t)((((uint64_t)(white) << 30) + ((uint32_t)255 << 15)) / ((uint32_t)255 << 16)))

#define RATIOS(red, green, blue)                                                                   \
    {                                                                                              \
        RATIO_Q30(red), RATIO_Q30(green), RATIO_Q30(blue)                                          \
    }

static inline uint32_t rounded(int32_t channel)
{
    return (uint32_t)(channel + 0x8000) >> 16;
}

static uint32_t pack_565(const int32_t c[3])
{
    return rounded(c[0]) << 11 | rounded(c[1]) << 5 | rounded(c[2]);
}

static uint32_t pack_888(const int32_t c[3])
{
    return rounded(c[0]) << 16 | rounded(c[1]) << 8 | rounded(c[2]);
}

static uint32_t pack_gray(const int32_t c[3])
{
    return rounded(c[0] + c[1] + c[2]);
}

const qtri_colors qtri_colors_565 = {
    RATIOS((int32_t)31 << 16, (int32_t)63 << 16, (int32_t)31 << 16), false, 11, 5, pack_565};

const qtri_colors qtri_colors_888 = {
    RATIOS((int32_t)255 << 16, (int32_t)255 << 16, (int32_t)255 << 16), false, 16, 8, pack_888};

/* .299 .587 .114 of 255; the sum is 255 << 16 exactly. */
const qtri_colors qtri_colors_gray = {RATIOS(4996792, 9809756, 1905132), true, 0, 0, pack_gray};
