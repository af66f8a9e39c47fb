/* SPDX-License-Identifier: MIT */
#include "mix.h"

/*
 * What is stored is known by the function that decodes it; see format.h. Pixels of RGB565 whose
 * colours have 8 bits are mixed with those, as any other.
 */
qtri_mix qtri_mix_of(const qtri_format *format)
{
    const uint32_t bytes = format->pixels->bytes;
    if (format->decode == qtri_decode_rgb565 && format->colors->red == 11 && bytes == 2) {
        return QTRI_MIX_565;
    }
    if (format->decode == qtri_decode_rgb565_swapped && bytes == 2) {
        return QTRI_MIX_565_SWAPPED;
    }
    if (format->decode == qtri_decode_gray8 && bytes == 1) {
        return QTRI_MIX_GRAY8;
    }
    if (format->decode == qtri_decode_xrgb8888 && bytes == 4) {
        return QTRI_MIX_32;
    }
    const bool is_bytes =
        format->decode == qtri_decode_xrgb8888 || format->decode == qtri_decode_rgb888;
    return is_bytes && bytes == 3 ? QTRI_MIX_24 : QTRI_MIX_OTHER;
}

uint32_t qtri_mix_color(const qtri_format *format, uint32_t d, uint32_t color_888, uint32_t a)
{
    const uint32_t mixed = qtri_mix_bytes(format->decode(d), color_888, a);
    return qtri_pixel_from_rgb(format, qtri_rgb_from_888(mixed));
}

uint32_t qtri_mix_other(const qtri_format *format, uint32_t d, uint32_t s, uint32_t a)
{
    return qtri_mix_color(format, d, format->decode(s), a);
}
