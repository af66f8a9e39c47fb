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
