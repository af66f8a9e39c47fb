/* SPDX-License-Identifier: MIT */
#define PIPELINES qtri_pipelines_rgb565_x4
#define FORMAT    qtri_rgb565
#define SIZE      QTRI_RGB565_X4_BYTES
#include "samples_format.inc"

static uint32_t decode(uint32_t stored)
{
    return qtri_decode_rgb565(stored);
}

const qtri_format qtri_rgb565_x4 = {&records, &qtri_colors_565, NULL,
                                    decode,   &samples,         QTRI_RGB565};
