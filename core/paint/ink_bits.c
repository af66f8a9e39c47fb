/* SPDX-License-Identifier: MIT */
#include "ink.h"
#include "mix_stored.h"

/* All pixels have one weight: what is added to each is made once for a glyph. */
QTRI_INLINE void bits_of(qtri_mix mix, int32_t bytes, const qtri_painter *painter, uint8_t *to,
                         const qtri_ink_bits *bits)
{
    const uint32_t a = qtri_mix_weight(255, painter->alpha); /* < 256, or it would not be mixed */
    const qtri_mix_part share = qtri_mix_part_of(mix, &painter->channels, painter->stored, a);
    const uint8_t *row = bits->row;
    for (int32_t rows = bits->height; rows > 0; rows--) {
        uint8_t *next = to;
        for (int32_t done = 0; done < bits->width; done += 8) {
            const int32_t count = qtri_least32(bits->width - done, 8);
            uint32_t value = qtri_ink_bits_at(row, bits->skip + done, count) << 24;
            for (uint8_t *at = next; value != 0; value <<= 1) {
                if ((int32_t)value < 0) {
                    const uint32_t d = qtri_mix_get(mix, at);
                    qtri_mix_put(mix, at, qtri_mix_add(mix, d, 256 - a, share));
                }
                at += bytes;
            }
            next += 8 * bytes;
        }
        to += painter->surface->pitch;
        row += bits->stride;
    }
}

/* Those of eight pixels that a value, which is not 0, has bits for. */
static void cover_eight(const qtri_painter *painter, uint8_t *at, uint32_t value)
{
    uint8_t coverage[8];
    int32_t n = 0;
    for (; (value & 0x80) == 0; value <<= 1) {
        at += painter->surface->format->pixels->bytes;
    }
    for (; (value & 0xFF) != 0; value <<= 1) { /* up to the last bit */
        coverage[n++] = (uint8_t)(0 - (value >> 7 & 1));
    }
    painter->ink->cover(painter, at, n, coverage);
}

/* Of a format that is not known here. */
QTRI_NOINLINE static void bits_of_others(const qtri_painter *painter, uint8_t *to,
                                         const qtri_ink_bits *bits)
{
    const ptrdiff_t bytes = painter->surface->format->pixels->bytes;
    const uint8_t *row = bits->row;
    for (int32_t rows = bits->height; rows > 0; rows--) {
        for (int32_t done = 0; done < bits->width; done += 8) {
            const int32_t count = qtri_least32(bits->width - done, 8);
            const uint32_t value = qtri_ink_bits_at(row, bits->skip + done, count);
            if (value != 0) {
                cover_eight(painter, to + bytes * done, value);
            }
        }
        to += painter->surface->pitch;
        row += bits->stride;
    }
}

void qtri_blend_bits(const qtri_painter *painter, uint8_t *to, const qtri_ink_bits *bits)
{
    switch (qtri_mix_of(painter->surface->format)) {
    case QTRI_MIX_GRAY8:
        bits_of(QTRI_MIX_GRAY8, 1, painter, to, bits);
        break;
    case QTRI_MIX_565:
        bits_of(QTRI_MIX_565, 2, painter, to, bits);
        break;
    case QTRI_MIX_565_SWAPPED:
        bits_of(QTRI_MIX_565_SWAPPED, 2, painter, to, bits);
        break;
    case QTRI_MIX_24:
        bits_of(QTRI_MIX_24, 3, painter, to, bits);
        break;
    case QTRI_MIX_32:
        bits_of(QTRI_MIX_32, 4, painter, to, bits);
        break;
    default:
        bits_of_others(painter, to, bits);
        break;
    }
}
