/* SPDX-License-Identifier: MIT */
#define FORMAT qtri_gray8
#define SIZE   QTRI_GRAY8_X4_BYTES
#include "samples_format.inc"

static uint32_t decode(uint32_t stored)
{
    return qtri_decode_gray8(stored);
}

const qtri_format qtri_gray8_x4 = {&records, &qtri_colors_gray, NULL, decode, &samples, QTRI_GRAY8};
