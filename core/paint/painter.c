/* SPDX-License-Identifier: MIT */
/* Spans, rectangles, coverage and bits painted by a brush, opaque or blended. */
#include "painter.h"

#include "qtri/body/color.h"
#include "mix_stored.h"

#include "../frame/pixel.h"

bool qtri_painter_begin(qtri_painter *painter, const qtri_surface *surface, const qtri_brush *brush)
{
    QTRI_ASSERT(brush != NULL);
    painter->surface = surface;
    painter->ink = brush->ink;
    painter->bounds = qtri_surface_bounds(surface);
    painter->alpha = brush->ink != NULL ? brush->alpha : 255;
    if (painter->bounds.x0 == painter->bounds.x1 || painter->alpha == 0) {
        return false;
    }
    painter->stored = qtri_pixel_from_rgb(surface->format, brush->color);
    if (brush->ink != NULL) {
        painter->color_888 = qtri_pixel_rgb_to_888(&brush->color);
        painter->channels = qtri_channels_from_color(surface->format->colors, brush->color);
    }
    return true;
}

static bool is_opaque(const qtri_painter *painter, uint32_t coverage)
{
    return painter->ink == NULL || (painter->alpha & coverage) == 255;
}

void qtri_painter_span(const qtri_painter *painter, int32_t row, int32_t x0, int32_t x1,
                       uint32_t coverage)
{
    x0 = qtri_greatest32(x0, painter->bounds.x0);
    x1 = qtri_least32(x1, painter->bounds.x1);
    if (x0 >= x1) {
        return;
    }
    if (is_opaque(painter, coverage)) {
        const qtri_rect rect = {x0, row, x1, row + 1};
        qtri_fill_rect(painter->surface, &rect, painter->stored);
    } else {
        painter->ink->span(painter, qtri_surface_at(painter->surface, x0, row), x1 - x0, coverage);
    }
}

void qtri_painter_rect(const qtri_painter *painter, const qtri_rect *rect)
{
    const qtri_rect *bounds = &painter->bounds;
    const qtri_rect r = {qtri_greatest32(rect->x0, bounds->x0),
                         qtri_greatest32(rect->y0, bounds->y0), qtri_least32(rect->x1, bounds->x1),
                         qtri_least32(rect->y1, bounds->y1)};
    if (r.x0 >= r.x1 || r.y0 >= r.y1) {
        return;
    }
    if (is_opaque(painter, 255)) {
        qtri_fill_rect(painter->surface, &r, painter->stored);
        return;
    }
    for (int32_t row = r.y0; row < r.y1; row++) {
        painter->ink->span(painter, qtri_surface_at(painter->surface, r.x0, row), r.x1 - r.x0, 255);
    }
}

void qtri_hard_rect(const qtri_painter *painter, const qtri_area *box)
{
    const qtri_rect rect = {qtri_pixel_from(box->x0_24p8), qtri_pixel_from(box->y0_24p8),
                            qtri_pixel_from(box->x1_24p8), qtri_pixel_from(box->y1_24p8)};
    qtri_painter_rect(painter, &rect);
}

/* ---- Blended pixels ---- */

QTRI_INLINE void span_of(qtri_mix mix, uint32_t bytes, uint8_t *at, int32_t count, uint32_t keep,
                         qtri_mix_part share)
{
    for (const uint8_t *const end = at + (uint32_t)count * bytes; at != end; at += bytes) {
        qtri_save(bytes, at, qtri_mix_add(mix, qtri_load(bytes, at), keep, share));
    }
}

/* qtri_blend_cover() for QTRI_MIX_OTHER; `step`: 1, or 0 where all pixels have one coverage. */
QTRI_NOINLINE static void cover_others(const qtri_painter *painter, uint8_t *at, int32_t count,
                                       const uint8_t *coverage, int32_t step)
{
    const qtri_format *format = painter->surface->format;
    uint32_t color[QTRI_MIX_BATCH];
    for (; count > 0; count -= QTRI_MIX_BATCH) {
        const int32_t n = qtri_least32(count, QTRI_MIX_BATCH);
        uint32_t mask = 0;
        for (int32_t i = 0; i < n; i++) {
            const uint32_t a = qtri_mix_weight(*coverage, painter->alpha);
            coverage += step;
            mask = mask << 1 | (a != 0);
            color[i] = painter->color_888 | (a - (a != 0)) << 24;
        }
        qtri_mix_others(format, at, color, mask, n);
        at += (ptrdiff_t)format->pixels->bytes * n;
    }
}

void qtri_blend_span(const qtri_painter *painter, uint8_t *at, int32_t count, uint32_t coverage)
{
    const qtri_format *format = painter->surface->format;
    const qtri_mix mix = qtri_mix_of(format);
    const uint8_t even = (uint8_t)coverage;
    const uint32_t a = qtri_mix_weight(coverage, painter->alpha);
    const qtri_mix_part share = qtri_mix_part_of(mix, &painter->channels, painter->stored, a);
    switch (mix) {
        QTRI_MIX_CASES(span_of, at, count, 256 - a, share);
    default:
        cover_others(painter, at, count, &even, 0);
        break;
    }
}

/* Most pixels of a row of coverage are all or nothing. */
QTRI_INLINE void cover_of(qtri_mix mix, uint32_t bytes, const qtri_painter *painter, uint8_t *at,
                          int32_t count, const uint8_t *coverage)
{
    const uint32_t alpha = painter->alpha;
    const uint32_t stored = painter->stored;
    const qtri_channels channels = painter->channels;
    for (; count > 0; count--) {
        const uint32_t a = qtri_mix_weight(*coverage++, alpha);
        if (a == 256) {
            qtri_save(bytes, at, stored);
        } else if (a != 0) {
            const qtri_mix_part share = qtri_mix_part_of(mix, &channels, stored, a);
            qtri_save(bytes, at, qtri_mix_add(mix, qtri_load(bytes, at), 256 - a, share));
        }
        at += bytes;
    }
}

void qtri_blend_cover(const qtri_painter *painter, uint8_t *at, int32_t count,
                      const uint8_t *coverage)
{
    switch (qtri_mix_of(painter->surface->format)) {
        QTRI_MIX_CASES(cover_of, painter, at, count, coverage);
    default:
        cover_others(painter, at, count, coverage, 1);
        break;
    }
}

/* All pixels have one weight: the colour times it is computed once for a glyph. */
QTRI_INLINE void bits_of(qtri_mix mix, uint32_t bytes, const qtri_painter *painter, uint8_t *to,
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
            if (mix == QTRI_MIX_OTHER && value != 0) {
                uint8_t coverage[8];
                for (int32_t i = 0; i < 8; i++) {
                    coverage[i] = (uint8_t)(0 - (value << i >> 31));
                }
                cover_others(painter, next, count, coverage, 1);
                value = 0;
            }
            for (uint8_t *at = next; value != 0; value <<= 1) {
                if ((int32_t)value < 0) {
                    const uint32_t d = qtri_load(bytes, at);
                    qtri_save(bytes, at, qtri_mix_add(mix, d, 256 - a, share));
                }
                at += bytes;
            }
            next += 8 * bytes;
        }
        to += painter->surface->pitch;
        row += bits->stride;
    }
}

void qtri_blend_bits(const qtri_painter *painter, uint8_t *to, const qtri_ink_bits *bits)
{
    const uint32_t bytes = painter->surface->format->pixels->bytes;
    switch (qtri_mix_of(painter->surface->format)) {
        QTRI_MIX_CASES(bits_of, painter, to, bits);
    default:
        bits_of(QTRI_MIX_OTHER, bytes, painter, to, bits);
        break;
    }
}
