/* SPDX-License-Identifier: MIT */
/*
 * Two colours mixed, channel by channel. Internal.
 */
#ifndef QTRI_FRAME_MIX_H
#define QTRI_FRAME_MIX_H

#include "colors.h"

/* A share of 10 bits and 1 of an alpha of 8: 255 is 1024, and none is off by more than 2. */
static inline uint32_t qtri_mix_share(uint32_t alpha)
{
    return 4 * alpha + (alpha >> 6) + (alpha >> 7);
}

/* `over` in a share of `k`, the rest is `under`: within 1/2 and what the share is off. */
static inline uint32_t qtri_mix_over(uint32_t over, uint32_t under, uint32_t k)
{
    const int32_t difference = (int32_t)(over - under) * (int32_t)k; /* |.| <= 255 2^10 */
    return under + (uint32_t)((difference + 512) >> 10);
}

/* The same of whole RGB565 pixels: red and blue in lanes of 16 bits, 31 2^10 + 512 < 2^15. */
static inline uint32_t qtri_mix_over_565(uint32_t over, uint32_t under, uint32_t k)
{
    const uint32_t lanes = 0x001F001Fu;
    const uint32_t rest = 1024 - k;
    over &= 0xFFFF; /* colours may have more above */
    const uint32_t green = (over << 21 >> 26) * k + (under << 21 >> 26) * rest + 512;
    uint32_t both = ((over | over << 5) & lanes) * k + ((under | under << 5) & lanes) * rest;
    both = (both + 0x02000200u) >> 10 & lanes;
    return both | both >> 5 | green >> 10 << 5;
}

/* Any mixture of channels for an RGB565 pixel. */
#define QTRI_MIX_565(CHANNEL, c, o, k)                                                             \
    (CHANNEL((c) >> 11 & 31, (o) >> 11 & 31, k, 31u) << 11 |                                       \
     CHANNEL((c) >> 5 & 63, (o) >> 5 & 63, k, 63u) << 5 | CHANNEL((c)&31, (o)&31, k, 31u))

/*
 * CHANNEL(over, under, k, most) for all channels of color[i] and other[i], with k its share: SHARE;
 * PIXEL_565(over, under, k) is that for RGB565. A colour's high byte stays as it is.
 */
#define QTRI_MIX(color, other, count, kind, SHARE, CHANNEL, PIXEL_565)                             \
    if ((kind) == &qtri_colors_565) {                                                              \
        for (int32_t i = 0; i < (count); i++) {                                                    \
            const uint32_t c = (color)[i];                                                         \
            const uint32_t o = (other);                                                            \
            const uint32_t k = (SHARE);                                                            \
            (color)[i] = PIXEL_565(c, o, k);                                                       \
        }                                                                                          \
    } else if ((kind) == &qtri_colors_gray) {                                                      \
        for (int32_t i = 0; i < (count); i++) {                                                    \
            const uint32_t o = (other);                                                            \
            const uint32_t k = (SHARE);                                                            \
            (color)[i] = CHANNEL((color)[i] & 255, o & 255, k, 255u);                              \
        }                                                                                          \
    } else {                                                                                       \
        for (int32_t i = 0; i < (count); i++) {                                                    \
            const uint32_t c = (color)[i];                                                         \
            const uint32_t o = (other);                                                            \
            const uint32_t k = (SHARE);                                                            \
            (color)[i] = (c & 0xFF000000u) |                                                       \
                         CHANNEL(c >> 16 & 255, o >> 16 & 255, k, 255u) << 16 |                    \
                         CHANNEL(c >> 8 & 255, o >> 8 & 255, k, 255u) << 8 |                       \
                         CHANNEL(c & 255, o & 255, k, 255u);                                       \
        }                                                                                          \
    }

#endif
