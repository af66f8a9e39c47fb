/* SPDX-License-Identifier: MIT */
#include "mix_stored.h"

/*
 * A format is recognized by its `decode`; see format.h. RGB565 whose colours have 8 bits a channel
 * is QTRI_MIX_OTHER.
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

void qtri_mix_others(const qtri_format *format, uint8_t *at, uint32_t *color, uint32_t mask,
                     int32_t count)
{
    const qtri_pixels *pixels = format->pixels;
    const uint8_t *from = at;
    const uint32_t *end = color + count;
    for (uint32_t *c = color; c != end; c++) {
        const uint32_t d = format->decode(pixels->load(from));
        const uint32_t a = (*c >> 24) + 1;
        const qtri_mix_part share = qtri_mix_part_of_stored(QTRI_MIX_32, *c & 0x00FFFFFFu, a);
        *c = qtri_mix_add(QTRI_MIX_32, d, 256 - a, share);
        from += pixels->bytes;
    }
    qtri_mix_encode(format, color, count);
    pixels->store(at, color, mask, count);
}
