/* SPDX-License-Identifier: MIT */
#include "picture.h"

QTRI_INLINE void mix_of(qtri_mix mix, const qtri_format *format, uint8_t *at,
                        const uint32_t *stored, uint32_t mask, uint32_t a)
{
    const int32_t bytes = format->pixels->bytes;
    for (; mask != 0; mask <<= 1) {
        if ((int32_t)mask < 0) {
            const uint32_t d = qtri_mix_get(mix, format, at);
            qtri_mix_put(mix, format, at, qtri_mix_stored(mix, format, d, *stored, a));
        }
        stored++;
        at += bytes;
    }
}

void qtri_picture_mix(const qtri_surface *surface, uint8_t *at, const uint32_t *stored,
                      uint32_t mask, int32_t count, uint32_t a)
{
    const qtri_format *format = surface->format;
    mask <<= 32 - count;
    switch (qtri_mix_of(format)) {
    case QTRI_MIX_GRAY8:
        mix_of(QTRI_MIX_GRAY8, format, at, stored, mask, a);
        break;
    case QTRI_MIX_565:
        mix_of(QTRI_MIX_565, format, at, stored, mask, a);
        break;
    case QTRI_MIX_565_SWAPPED:
        mix_of(QTRI_MIX_565_SWAPPED, format, at, stored, mask, a);
        break;
    case QTRI_MIX_24:
        mix_of(QTRI_MIX_24, format, at, stored, mask, a);
        break;
    case QTRI_MIX_32:
        mix_of(QTRI_MIX_32, format, at, stored, mask, a);
        break;
    default:
        mix_of(QTRI_MIX_OTHER, format, at, stored, mask, a);
        break;
    }
}
