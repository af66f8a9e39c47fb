#include "pixel.h"

#include "../bits/bits.h"

/* white / (255 << 16) in Q30, rounded: times a colour of 24 bits, off by less than 2^-6 units. */
#define RATIO_Q30(white)                                                                           \
    ((uint32_t)((((uint64_t)(white) << 30) + ((uint32_t)255 << 15)) / ((uint32_t)255 << 16)))

/* Rounded. A ratio of 1 is 0 in Q32. */
static int32_t scaled(int32_t color_8p16, uint32_t ratio_q30)
{
    const uint32_t white = (uint32_t)255 << 16;
    uint32_t c = (uint32_t)color_8p16;
    if (c > white) {
        QTRI_RARELY();
        c = color_8p16 < 0 ? 0 : white;
    }
    uint32_t ratio_q32 = ratio_q30 << 2;
    if (ratio_q32 != 0) {
        c = (uint32_t)((qtri_mul_u32(c, ratio_q32) + ((uint32_t)1 << 31)) >> 32);
    }
    return (int32_t)c;
}

qtri_channels qtri_channels_from_color(qtri_format format, const int32_t color_8p16[3])
{
    static const uint32_t ratio_q30[3][3] = {
        {RATIO_Q30((uint32_t)31 << 16), RATIO_Q30((uint32_t)63 << 16),
         RATIO_Q30((uint32_t)31 << 16)},
        {RATIO_Q30((uint32_t)255 << 16), RATIO_Q30((uint32_t)255 << 16),
         RATIO_Q30((uint32_t)255 << 16)},
        {RATIO_Q30(QTRI_GRAY_RED), RATIO_Q30(QTRI_GRAY_GREEN), RATIO_Q30(QTRI_GRAY_BLUE)},
    };
    format = qtri_format_built(format);
    const uint32_t *ratio = ratio_q30[format <= QTRI_GRAY8 ? format : QTRI_GRAY8];
    qtri_channels result = {{scaled(color_8p16[0], ratio[0]), scaled(color_8p16[1], ratio[1]),
                             scaled(color_8p16[2], ratio[2])}};
    return result;
}

uint32_t qtri_pixel_from_rgb(qtri_format format, qtri_rgb color)
{
    int32_t color_8p16[3] = {(int32_t)color.r << 16, (int32_t)color.g << 16,
                             (int32_t)color.b << 16};
    qtri_channels channels = qtri_channels_from_color(format, color_8p16);
    return qtri_pixel_pack(format, &channels);
}

/* Of 31 and of 63 in 0..255, rounded: (255 x + 15) / 31 and (255 x + 31) / 63 for all x. */
static uint8_t widen5(uint32_t x)
{
    return (uint8_t)((x * 527 + 23) >> 6);
}

static uint8_t widen6(uint32_t x)
{
    return (uint8_t)((x * 259 + 33) >> 6);
}

qtri_rgb qtri_rgb_from_565(uint32_t pixel)
{
    qtri_rgb rgb = {widen5(pixel >> 11), widen6((pixel >> 5) & 63), widen5(pixel & 31)};
    return rgb;
}

qtri_rgb qtri_rgb_from_8888(uint32_t pixel)
{
    qtri_rgb rgb = {(uint8_t)(pixel >> 16), (uint8_t)(pixel >> 8), (uint8_t)pixel};
    return rgb;
}

qtri_rgb qtri_pixel_widen(qtri_format format, const uint8_t *row, int32_t x)
{
    switch (format) {
    case QTRI_RGB565:
        return qtri_rgb_from_565(((const uint16_t *)(const void *)row)[x]);
    case QTRI_XRGB8888:
        return qtri_rgb_from_8888(((const uint32_t *)(const void *)row)[x]);
    default: {
        qtri_rgb gray = {row[x], row[x], row[x]};
        return gray;
    }
    }
}
