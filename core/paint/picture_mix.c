/* SPDX-License-Identifier: MIT */
#include "picture.h"

QTRI_INLINE void mix_of(qtri_mix mix, int32_t bytes, uint8_t *at, const uint32_t *stored,
                        uint32_t mask, uint32_t a)
{
    for (; mask != 0; mask <<= 1) {
        if ((int32_t)mask < 0) {
            const uint32_t d = qtri_mix_get(mix, at);
            qtri_mix_put(mix, at, qtri_mix_stored(mix, d, *stored, a));
        }
        stored++;
        at += bytes;
    }
}

/* With colours as they would be stored. */
static void mix_others(const qtri_format *format, uint8_t *at, uint32_t *stored, uint32_t mask,
                       int32_t count, uint32_t a)
{
    for (int32_t i = 0; i < count; i++) {
        stored[i] = (format->decode(stored[i]) & 0x00FFFFFFu) | (a - 1) << 24;
    }
    qtri_mix_others(format, at, stored, mask, count);
}

void qtri_picture_mix(const qtri_surface *surface, uint8_t *at, uint32_t *stored, uint32_t mask,
                      int32_t count, uint32_t a)
{
    const qtri_format *format = surface->format;
    const uint32_t first = mask << (32 - count); /* the sign is the first pixel's */
    switch (qtri_mix_of(format)) {
    case QTRI_MIX_GRAY8:
        mix_of(QTRI_MIX_GRAY8, 1, at, stored, first, a);
        break;
    case QTRI_MIX_565:
        mix_of(QTRI_MIX_565, 2, at, stored, first, a);
        break;
    case QTRI_MIX_565_SWAPPED:
        mix_of(QTRI_MIX_565_SWAPPED, 2, at, stored, first, a);
        break;
    case QTRI_MIX_24:
        mix_of(QTRI_MIX_24, 3, at, stored, first, a);
        break;
    case QTRI_MIX_32:
        mix_of(QTRI_MIX_32, 4, at, stored, first, a);
        break;
    default:
        mix_others(format, at, stored, mask, count, a);
        break;
    }
}
