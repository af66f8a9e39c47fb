/* SPDX-License-Identifier: MIT */
#define FORMAT qtri_rgb888
#define SIZE   QTRI_RGB888_X4_BYTES
#include "samples_format.inc"

#include "../frame/barrier.h"

static void encode(uint32_t *color, int32_t count)
{
    QTRI_EACH_WORD(color, count, c, qtri_reversed(c) >> 8)
}

static uint32_t decode(uint32_t stored)
{
    return qtri_decode_rgb888(stored);
}

const qtri_format qtri_rgb888_x4 = {&records, &qtri_colors_888, encode,
                                    decode,   &samples,         QTRI_RGB888};
