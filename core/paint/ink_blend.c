/* SPDX-License-Identifier: MIT */
#include "ink.h"
#include "mix_stored.h"

QTRI_INLINE void span_of(qtri_mix mix, uint8_t *at, int32_t bytes, int32_t count, uint32_t keep,
                         qtri_mix_part share)
{
    for (; count > 0; count--) {
        const uint32_t mixed = qtri_mix_add(mix, qtri_mix_get(mix, at), keep, share);
        qtri_mix_put(mix, at, mixed);
        at += bytes;
    }
}

/* Of a format that is not known here. */
QTRI_NOINLINE static void cover_others(const qtri_painter *painter, uint8_t *at, int32_t count,
                                       const uint8_t *coverage)
{
    const qtri_format *format = painter->surface->format;
    uint32_t color[QTRI_MIX_BATCH];
    for (; count > 0; count -= QTRI_MIX_BATCH) {
        const int32_t n = qtri_least32(count, QTRI_MIX_BATCH);
        uint32_t mask = 0;
        for (int32_t i = 0; i < n; i++) {
            const uint32_t a = qtri_mix_weight(*coverage++, painter->alpha);
            mask = mask << 1 | (a != 0);
            color[i] = painter->color_888 | (a - (a != 0)) << 24;
        }
        qtri_mix_others(format, at, color, mask, n);
        at += (ptrdiff_t)format->pixels->bytes * n;
    }
}

QTRI_NOINLINE static void span_of_others(const qtri_painter *painter, uint8_t *at, int32_t count,
                                         uint32_t coverage)
{
    const ptrdiff_t bytes = painter->surface->format->pixels->bytes;
    const int32_t most = qtri_least32(count, QTRI_MIX_BATCH);
    uint8_t same[QTRI_MIX_BATCH];
    for (int32_t i = 0; i < most; i++) {
        same[i] = (uint8_t)coverage;
    }
    for (; count > 0; count -= QTRI_MIX_BATCH) {
        cover_others(painter, at, qtri_least32(count, QTRI_MIX_BATCH), same);
        at += QTRI_MIX_BATCH * bytes;
    }
}

void qtri_blend_span(const qtri_painter *painter, uint8_t *at, int32_t count, uint32_t coverage)
{
    const qtri_format *format = painter->surface->format;
    const qtri_mix mix = qtri_mix_of(format);
    const uint32_t a = qtri_mix_weight(coverage, painter->alpha);
    const qtri_mix_part share = qtri_mix_part_of(mix, &painter->channels, painter->stored, a);
    switch (mix) {
    case QTRI_MIX_GRAY8:
        span_of(QTRI_MIX_GRAY8, at, 1, count, 256 - a, share);
        break;
    case QTRI_MIX_565:
        span_of(QTRI_MIX_565, at, 2, count, 256 - a, share);
        break;
    case QTRI_MIX_565_SWAPPED:
        span_of(QTRI_MIX_565_SWAPPED, at, 2, count, 256 - a, share);
        break;
    case QTRI_MIX_24:
        span_of(QTRI_MIX_24, at, 3, count, 256 - a, share);
        break;
    case QTRI_MIX_32:
        span_of(QTRI_MIX_32, at, 4, count, 256 - a, share);
        break;
    default:
        span_of_others(painter, at, count, coverage);
        break;
    }
}

/* Most pixels of a row of coverage are all or nothing. */
QTRI_INLINE void cover_of(qtri_mix mix, int32_t bytes, const qtri_painter *painter, uint8_t *at,
                          int32_t count, const uint8_t *coverage)
{
    const uint32_t alpha = painter->alpha;
    const uint32_t stored = painter->stored;
    const qtri_channels channels = painter->channels;
    for (; count > 0; count--) {
        const uint32_t a = qtri_mix_weight(*coverage++, alpha);
        if (a == 256) {
            qtri_mix_put(mix, at, stored);
        } else if (a != 0) {
            const qtri_mix_part share = qtri_mix_part_of(mix, &channels, stored, a);
            qtri_mix_put(mix, at, qtri_mix_add(mix, qtri_mix_get(mix, at), 256 - a, share));
        }
        at += bytes;
    }
}

void qtri_blend_cover(const qtri_painter *painter, uint8_t *at, int32_t count,
                      const uint8_t *coverage)
{
    switch (qtri_mix_of(painter->surface->format)) {
    case QTRI_MIX_GRAY8:
        cover_of(QTRI_MIX_GRAY8, 1, painter, at, count, coverage);
        break;
    case QTRI_MIX_565:
        cover_of(QTRI_MIX_565, 2, painter, at, count, coverage);
        break;
    case QTRI_MIX_565_SWAPPED:
        cover_of(QTRI_MIX_565_SWAPPED, 2, painter, at, count, coverage);
        break;
    case QTRI_MIX_24:
        cover_of(QTRI_MIX_24, 3, painter, at, count, coverage);
        break;
    case QTRI_MIX_32:
        cover_of(QTRI_MIX_32, 4, painter, at, count, coverage);
        break;
    default:
        cover_others(painter, at, count, coverage);
        break;
    }
}

const qtri_ink qtri_ink_blend = {qtri_blend_span, qtri_blend_cover, qtri_blend_bits, qtri_hard_row,
                                 qtri_hard_rect};
