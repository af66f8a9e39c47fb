/* SPDX-License-Identifier: MIT */
#include "pixel.h"

#include "../bits/bits.h"

/*
 * A channel of 0..255.0, n.16, in units of which there are ratio_q30 2^-30 to one, n.16, rounded
 * down: with 8 of its bits after the point, so that no product is longer than 32 bits. It is off by
 * 1/512 of a step of 255; of colours of 8 bits by nothing.
 */
static inline uint32_t channel_scaled(uint32_t channel_8p16, uint32_t ratio_q30)
{
    const uint32_t q8 = (channel_8p16 + 128) >> 8; /* <= 65280 */
#if QTRI_LONG_MULTIPLY
    return (uint32_t)(((uint64_t)(q8 << 10) * ratio_q30) >> 32);
#else
    const uint32_t low = q8 * (ratio_q30 & (((uint32_t)1 << 14) - 1)); /* < 2^30 */
    return (q8 * (ratio_q30 >> 14) + (low >> 14)) >> 8;                /* <= 65280 2^16 */
#endif
}

static int32_t scaled(int32_t color_8p16, uint32_t ratio_q30)
{
    const uint32_t white = (uint32_t)255 << 16;
    uint32_t c = (uint32_t)color_8p16;
    if (c > white) {
        QTRI_RARELY();
        c = color_8p16 < 0 ? 0 : white;
    }
    return (int32_t)channel_scaled(c, ratio_q30);
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
