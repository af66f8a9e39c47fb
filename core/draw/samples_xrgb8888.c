/* SPDX-License-Identifier: MIT */
#define FORMAT qtri_xrgb8888
#define SIZE   QTRI_XRGB8888_X4_BYTES
#include "samples_format.inc"

static uint32_t decode(uint32_t stored)
{
    return qtri_decode_xrgb8888(stored);
}

const qtri_format qtri_xrgb8888_x4 = {&records, &qtri_colors_888, NULL,
                                      decode,   &samples,         QTRI_XRGB8888};
