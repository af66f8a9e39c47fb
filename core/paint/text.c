/* SPDX-License-Identifier: MIT */
/* UTF-8 text in bitmap fonts. */
#include "contour.h"

#include "qtri/error.h"
#include "qtri/paint.h"

#include "../bits/bits.h"
#include "../frame/pixel.h"

/* How many bytes 10xxxxxx follow a byte 110xxxxx, 1110xxxx or 11110xxx; -1: it is neither. */
static int32_t continuation_bytes(uint32_t first)
{
    return first >= 0xF8 || first < 0xC0 ? -1 : (first >= 0xF0 ? 3 : (first >= 0xE0 ? 2 : 1));
}

uint32_t qtri_text_next(const char **text)
{
    QTRI_ASSERT(text != NULL && *text != NULL);
    static const uint32_t least[4] = {0, 0x80, 0x800, 0x10000};
    const uint32_t wrong = 0xFFFD;
    const char *at = *text;
    const uint32_t first = (uint8_t)*at;
    if (first < 0x80) {
        *text = at + (first != 0);
        return first;
    }
    *text = at + 1;
    const int32_t count = continuation_bytes(first);
    if (count < 0) {
        return wrong;
    }
    uint32_t character = first & (0x3Fu >> count);
    for (int32_t i = 1; i <= count; i++) { /* a zero ends it: it does not follow */
        const uint32_t next = (uint8_t)at[i];
        if ((next & 0xC0) != 0x80) {
            return wrong;
        }
        character = character << 6 | (next & 0x3F);
    }
    if (character < least[count] || character > 0x10FFFF || (character >> 11) == 0x1B) {
        return wrong;
    }
    *text = at + 1 + count;
    return character;
}

#define BIT(i)                                                                                     \
    if ((int32_t)(value << (i)) < 0) {                                                             \
        QTRI_BODY_BRANCH();                                                                        \
        qtri_save(bytes, at + (i)*bytes, stored);                                                  \
    }

/* Eight pixels of 1 to 4 bytes. */
QTRI_INLINE void paint_eight(uint32_t bytes, uint8_t *at, uint32_t value, uint32_t stored)
{
    value <<= 24;
    if (QTRI_BODY_IS_SMALL) {
        for (; value != 0; value <<= 1, at += bytes) {
            BIT(0)
        }
        return;
    }
    BIT(0)
    BIT(1)
    BIT(2)
    BIT(3)
    BIT(4)
    BIT(5)
    BIT(6)
    BIT(7)
}

/*
 * The `count` pixels behind the first `skip` of a byte of each row. Those in front leave the word
 * where it is shifted up.
 */
QTRI_INLINE void paint_column(uint32_t bytes, const qtri_painter *painter, uint8_t *to,
                              const uint8_t *row, int32_t stride, int32_t rows, int32_t skip,
                              int32_t count)
{
    const uint32_t stored = painter->stored;
    const ptrdiff_t pitch = painter->surface->pitch;
    const uint32_t within = 0xFF00u >> (skip + count); /* of the low eight bits */
    const uint8_t *end = row + (ptrdiff_t)rows * stride;
    for (; row != end; row += stride) {
        const uint32_t value = (*row & within) << skip;
        if (value != 0) {
            paint_eight(bytes, to, value, stored);
        }
        to += pitch;
    }
}

/* Whole rows of up to eight pixels, which nothing clips: most characters. */
QTRI_INLINE void paint_narrow(uint32_t bytes, const qtri_painter *painter, uint8_t *to,
                              const qtri_ink_bits *b)
{
    paint_column(bytes, painter, to, b->row, 1, b->height, 0, b->width);
}

/* Wide characters, and clipped ones: a column of bytes at a time. */
QTRI_INLINE void paint_columns(uint32_t bytes, const qtri_painter *painter, uint8_t *to,
                               const qtri_ink_bits *b)
{
    const uint8_t *row = b->row + (b->skip >> 3);
    int32_t skip = b->skip & 7;
    for (int32_t left = b->width; left > 0; skip = 0) {
        const int32_t count = qtri_least32(8 - skip, left);
        paint_column(bytes, painter, to, row++, b->stride, b->height, skip, count);
        to += (uint32_t)count * bytes;
        left -= count;
    }
}

/* Pixels of another size, and where code is to be small any that paint_narrow() leaves. */
QTRI_NOINLINE static void paint_others(const qtri_painter *painter, uint8_t *to,
                                       const qtri_ink_bits *b)
{
    const qtri_pixels *pixels = painter->surface->format->pixels;
    const uint8_t *row = b->row;
    for (int32_t rows = b->height; rows > 0; rows--) {
        uint8_t *at = to;
        for (int32_t done = 0; done < b->width; done += 8) {
            const int32_t count = qtri_least32(b->width - done, 8);
            const uint32_t value = qtri_ink_bits_at(row, b->skip + done, count);
            if (value != 0) {
                pixels->fill(at, painter->stored, value >> (8 - count), count);
            }
            at += 8 * (ptrdiff_t)pixels->bytes;
        }
        to += painter->surface->pitch;
        row += b->stride;
    }
}

/* x, y: the left upper corner; beyond the largest frame on either side nothing is to be seen. */
static void paint_glyph(const qtri_painter *painter, const qtri_font *font, const qtri_glyph *glyph,
                        int32_t x, int32_t y)
{
    const qtri_rect *bounds = &painter->bounds;
    const int32_t limit = 2 * QTRI_SURFACE_MAX;
    if (x < -limit || x > limit || y < -limit || y > limit) {
        return;
    }
    const int32_t x0 = qtri_greatest32(x, bounds->x0);
    const int32_t x1 = qtri_least32(x + glyph->width, bounds->x1);
    const int32_t y0 = qtri_greatest32(y, bounds->y0);
    const int32_t y1 = qtri_least32(y + glyph->height, bounds->y1);
    if (x0 >= x1 || y0 >= y1) {
        return;
    }
    const int32_t stride = (glyph->width + 7) >> 3;
    const qtri_ink_bits b = {font->rows + glyph->first + (y0 - y) * stride, stride, x0 - x, x1 - x0,
                             y1 - y0};
    uint8_t *to = qtri_surface_at(painter->surface, x0, y0);
    const uint32_t bytes = painter->surface->format->pixels->bytes;
    const bool is_narrow = stride == 1 && b.width == glyph->width;
    if (painter->ink != NULL && painter->alpha != 255) {
        painter->ink->bits(painter, to, &b);
    } else if (bytes - 1 > 3 || (QTRI_BODY_IS_SMALL && !is_narrow)) {
        paint_others(painter, to, &b);
    } else if (is_narrow) {
        switch (bytes) {
            QTRI_BYTES_CASES(paint_narrow, painter, to, &b);
        }
    } else {
        switch (bytes) {
            QTRI_BYTES_CASES(paint_columns, painter, to, &b);
        }
    }
}

static int32_t add_saturated(int32_t a, int32_t b)
{
    return qtri_saturate32((int64_t)a + b);
}

#ifdef QTRI_CHECKED
static void check_font(const qtri_font *font)
{
    QTRI_ASSERT(font != NULL);
    QTRI_ASSERT(font->rows != NULL && font->glyphs != NULL);
    QTRI_ASSERT(font->ranges != NULL || font->range_count == 0);
}
#endif

const qtri_glyph *qtri_font_glyph(const qtri_font *font, uint32_t character)
{
    QTRI_CHECK(check_font(font));
    for (uint32_t i = 0; i < font->range_count; i++) {
        const qtri_glyph_range *range = &font->ranges[i];
        if (character - range->first < range->count) {
            return &font->glyphs[range->glyph + (character - range->first)];
        }
    }
    return &font->glyphs[font->missing];
}

int32_t qtri_text_paint(const qtri_surface *surface, const qtri_font *font, int32_t x, int32_t y,
                        const char *text, const qtri_brush *brush)
{
    QTRI_CHECK(check_font(font));
    QTRI_ASSERT(text != NULL);
    qtri_painter painter;
    const bool is_seen = qtri_painter_begin(&painter, surface, brush);
    int32_t pen = x;
    for (;;) {
        const uint32_t character = qtri_text_next(&text);
        if (character == 0) {
            return pen;
        }
        if (character == '\n') {
            pen = x;
            y = add_saturated(y, font->ascent + font->descent);
            continue;
        }
        const qtri_glyph *glyph = qtri_font_glyph(font, character);
        if (is_seen) {
            paint_glyph(&painter, font, glyph, add_saturated(pen, glyph->left),
                        add_saturated(y, -glyph->top));
        }
        pen = add_saturated(pen, glyph->advance);
    }
}

int32_t qtri_text_width(const qtri_font *font, const char *text)
{
    QTRI_CHECK(check_font(font));
    QTRI_ASSERT(text != NULL);
    int32_t widest = 0;
    int32_t pen = 0;
    for (;;) {
        const uint32_t character = qtri_text_next(&text);
        widest = qtri_greatest32(widest, pen);
        if (character == 0) {
            return widest;
        }
        pen = character == '\n' ? 0 : add_saturated(pen, qtri_font_glyph(font, character)->advance);
    }
}
