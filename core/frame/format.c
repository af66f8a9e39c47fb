/* SPDX-License-Identifier: MIT */
#include "qtri/format.h"

/* Of 31 and of 63 in 0..255, rounded: (255 x + 15) / 31 and (255 x + 31) / 63 for all x. */
static uint32_t widen5(uint32_t x)
{
    return (x * 527 + 23) >> 6;
}

static uint32_t widen6(uint32_t x)
{
    return (x * 259 + 33) >> 6;
}

uint32_t qtri_decode_rgb565(uint32_t stored)
{
    return widen5((stored >> 11) & 31) << 16 | widen6((stored >> 5) & 63) << 8 |
           widen5(stored & 31);
}

uint32_t qtri_decode_rgb565_swapped(uint32_t stored)
{
    return qtri_decode_rgb565((stored & 0xFF) << 8 | ((stored >> 8) & 0xFF));
}

uint32_t qtri_decode_rgb888(uint32_t stored)
{
    return (stored & 0xFF) << 16 | (stored & 0xFF00) | ((stored >> 16) & 0xFF);
}

uint32_t qtri_decode_xrgb8888(uint32_t stored)
{
    return stored & 0xFFFFFF;
}

uint32_t qtri_decode_gray8(uint32_t stored)
{
    return (stored & 0xFF) * 0x010101u;
}
