/* SPDX-License-Identifier: MIT */
#define FORMAT qtri_rgb565_swapped
#define SIZE   QTRI_RGB565_X4_BYTES
#include "../frame/barrier.h"
#include "samples_format.inc"

static void encode(uint32_t *color, int32_t count)
{
    QTRI_EACH_WORD(color, count, c, qtri_reversed(c) >> 16)
}

static uint32_t decode(uint32_t stored)
{
    return qtri_decode_rgb565_swapped(stored);
}

const qtri_format qtri_rgb565_swapped_x4 = {&records, &qtri_colors_565, encode,
                                            decode,   &samples,         QTRI_RGB565_SWAPPED};
