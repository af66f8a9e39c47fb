/* SPDX-License-Identifier: MIT */
/*
 * Two colours mixed, channel by channel. Internal.
 */
#ifndef QTRI_FRAME_MIX_H
#define QTRI_FRAME_MIX_H

#include "barrier.h"
#include "colors.h"

/* ONE(i) for `count` words of colours, which move on, and up to three more. */
#ifdef __OPTIMIZE_SIZE__
#define QTRI_MIX_WORDS(color, count)                                                               \
    for (const uint32_t *end = (color) + (count); (color) < end; (color)++) {                      \
        ONE(0)                                                                                     \
    }
#else
#define QTRI_MIX_WORDS(color, count)                                                               \
    for (const uint32_t *end = (color) + (count); (color) < end; (color) += 4) {                   \
        ONE(0)                                                                                     \
        ONE(1)                                                                                     \
        ONE(2)                                                                                     \
        ONE(3)                                                                                     \
    }
#endif

/* `over` in a share of `k` of 1024, the rest is `under`: within 1/2 and what the share is off. */
static inline uint32_t qtri_mix_over(uint32_t over, uint32_t under, uint32_t k)
{
    const int32_t difference = (int32_t)(over - under) * (int32_t)k; /* |.| <= 255 2^10 */
    return under + (uint32_t)((difference + 512) >> 10);
}

/*
 * CHANNEL(over, under, k, most) for all channels of color[i] and other[i], of 8 bits, with k its
 * share: SHARE. A colour's high byte stays as it is.
 */
#define QTRI_MIX(color, other, count, kind, SHARE, CHANNEL)                                        \
    if ((kind) == &qtri_colors_gray) {                                                             \
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
