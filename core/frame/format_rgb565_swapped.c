/* SPDX-License-Identifier: MIT */
#include "qtri/format.h"

#include "barrier.h"

static void encode(uint32_t *color, int32_t count)
{
    QTRI_EACH_WORD(color, count, c, qtri_reversed(c) >> 16)
}

const qtri_format qtri_rgb565_swapped = {
    &qtri_pixels_16,    &qtri_colors_565, encode, qtri_decode_rgb565_swapped, NULL,
    QTRI_RGB565_SWAPPED};
