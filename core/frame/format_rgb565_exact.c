/* SPDX-License-Identifier: MIT */
#include "qtri/format.h"

#include "barrier.h"

/*
 * Channels of 8 bits to nearest, c 31 / 255 as (249 c + 1014) / 2^11 and c 63 / 255 as
 * (253 c + 505) / 2^10, rounded down: right for all 256. Red and blue in one product, whose halves
 * stay below 2^16: 249 255 + 1014 = 64509.
 */
#define ROUNDED(c) (((c)&0xFF00FF) * 249 + 1014 * 0x10001u)
#define GREEN(c)   ((((c) >> 8 & 0xFF) * 253 + 505) >> 10)

static void encode(uint32_t *color, int32_t count)
{
    QTRI_EACH_WORD(color, count, c,
                   (ROUNDED(c) >> 16 & 0xF800) | GREEN(c) << 5 | (ROUNDED(c) >> 11 & 31))
}

const qtri_format qtri_rgb565_exact = {
    &qtri_pixels_16, &qtri_colors_888, encode, qtri_decode_rgb565, NULL, QTRI_RGB565_EXACT};
