/* SPDX-License-Identifier: MIT */
#include "ink.h"
#include "mix.h"

QTRI_INLINE void span_of(qtri_mix mix, uint8_t *at, int32_t bytes, int32_t count, uint32_t keep,
                         qtri_mix_part share)
{
    for (; count > 0; count--) {
        const uint32_t mixed = qtri_mix_add(mix, qtri_mix_get(mix, NULL, at), keep, share);
        qtri_mix_put(mix, NULL, at, mixed);
        at += bytes;
    }
}

static void span_of_other(const qtri_painter *painter, uint8_t *at, int32_t count, uint32_t a)
{
    const qtri_format *format = painter->surface->format;
    for (; count > 0; count--) {
        const uint32_t d = format->pixels->load(at);
        qtri_mix_put(QTRI_MIX_OTHER, format, at, qtri_mix_color(format, d, painter->color_888, a));
        at += format->pixels->bytes;
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
        span_of_other(painter, at, count, a);
        break;
    }
}

/* Most pixels of a row of coverage are all or nothing. */
QTRI_INLINE void cover_of(qtri_mix mix, const qtri_painter *painter, uint8_t *at, int32_t count,
                          const uint8_t *coverage)
{
    const qtri_format *format = painter->surface->format;
    const int32_t bytes = format->pixels->bytes;
    const uint32_t alpha = painter->alpha;
    const uint32_t stored = painter->stored;
    const qtri_channels channels = painter->channels;
    for (; count > 0; count--) {
        const uint32_t a = qtri_mix_weight(*coverage++, alpha);
        if (a == 256) {
            qtri_mix_put(mix, format, at, stored);
        } else if (a != 0) {
            const uint32_t d = qtri_mix_get(mix, format, at);
            uint32_t mixed;
            if (mix == QTRI_MIX_OTHER) {
                mixed = qtri_mix_color(format, d, painter->color_888, a);
            } else {
                mixed = qtri_mix_add(mix, d, 256 - a, qtri_mix_part_of(mix, &channels, stored, a));
            }
            qtri_mix_put(mix, format, at, mixed);
        }
        at += bytes;
    }
}

void qtri_blend_cover(const qtri_painter *painter, uint8_t *at, int32_t count,
                      const uint8_t *coverage)
{
    switch (qtri_mix_of(painter->surface->format)) {
    case QTRI_MIX_GRAY8:
        cover_of(QTRI_MIX_GRAY8, painter, at, count, coverage);
        break;
    case QTRI_MIX_565:
        cover_of(QTRI_MIX_565, painter, at, count, coverage);
        break;
    case QTRI_MIX_565_SWAPPED:
        cover_of(QTRI_MIX_565_SWAPPED, painter, at, count, coverage);
        break;
    case QTRI_MIX_24:
        cover_of(QTRI_MIX_24, painter, at, count, coverage);
        break;
    case QTRI_MIX_32:
        cover_of(QTRI_MIX_32, painter, at, count, coverage);
        break;
    default:
        cover_of(QTRI_MIX_OTHER, painter, at, count, coverage);
        break;
    }
}

const qtri_ink qtri_ink_blend = {qtri_blend_span, qtri_blend_cover, qtri_hard_row, qtri_hard_rect};
