/* SPDX-License-Identifier: MIT */
#include "fxaa.h"

#include "../frame/barrier.h"

/* Lumas of two pixels, the first in the lower half: what is masked is masked once for both. */
static inline uint32_t lumas_565(uint32_t first, uint32_t second)
{
    const uint32_t two = first | second << 16;
    return (two >> 10 & 0x003E003Eu) + (two >> 4 & 0x007E007Eu) + (two & 0x001F001Fu);
}

static inline int32_t luma_sum_565(uint32_t a, uint32_t b)
{
    const uint32_t lumas = lumas_565(a, b);
    return (int32_t)((lumas + (lumas >> 16)) & 0xFFFF);
}

#define NAME(name)      name##_565
#define LUMAS(a, b)     luma_sum_565(a, b)
#define COLOR           uint16_t
#define LUMA(c)         ((int32_t)(2u * ((c) >> 11) + ((uint32_t)(c) >> 4 & 0x7E) + ((c)&31u)))
#define MIX(w, a, b, s) qtri_lerp_565(a, b, s)
#include "fxaa.inc"

enum { ROWS = 3 }; /* old colours that are kept: of this row and two above */

static void filter_pixels(const window_565 *w, uint16_t *out, int32_t x, int32_t end, int32_t width)
{
    for (; x < end; x++) {
        out[x] = (uint16_t)filter_565(w, x, width);
    }
}

/* Pixels x and x + 1 where one of them differs from its neighbours. */
QTRI_NOINLINE static void filter_two(const window_565 *w, uint16_t *out, int32_t x, int32_t width)
{
    const uint16_t *up = w->row[1] + x;
    const uint16_t *own = w->row[2] + x;
    const uint16_t *down = w->row[3] + x;
    const uint32_t both = lumas_565(own[0], own[1]);
    const uint32_t above = lumas_565(up[0], up[1]);
    const uint32_t below = lumas_565(down[0], down[1]);
    const uint32_t beside = lumas_565(own[-1], own[2]);
    const int32_t first = (int32_t)(both & 0xFFFF);
    const int32_t second = (int32_t)(both >> 16);
    const int32_t luma[5] = {first, (int32_t)(above & 0xFFFF), (int32_t)(below & 0xFFFF),
                             (int32_t)(beside & 0xFFFF), second};
    if (!qtri_fxaa_is_flat(first, luma[1], luma[2], luma[3], second)) {
        out[x] = (uint16_t)resolve_565(w, x, width, luma);
    }
    const int32_t next[5] = {second, (int32_t)(above >> 16), (int32_t)(below >> 16), first,
                             (int32_t)(beside >> 16)};
    if (!qtri_fxaa_is_flat(second, next[1], next[2], first, next[4])) {
        out[x + 1] = (uint16_t)resolve_565(w, x + 1, width, next);
    }
}

/*
 * Columns x..end - 1, x even and at least 2, of rows of whole words: two pixels that are
 * as all their neighbours are done with a look.
 */
QTRI_NOINLINE static void filter_pairs(const window_565 *w, uint16_t *out, int32_t x, int32_t end,
                                       int32_t width)
{
    const qtri_pair *up = (const qtri_pair *)(const void *)(w->row[1] + x);
    const qtri_pair *own = (const qtri_pair *)(const void *)(w->row[2] + x);
    const qtri_pair *down = (const qtri_pair *)(const void *)(w->row[3] + x);
    int32_t left = end - x;
    while (left >= 2) {
        const uint32_t two = own[0];
        if (two == up[0] && two == down[0] && two == (two << 16 | two >> 16)) {
            const uint16_t *pixel = (const uint16_t *)(const void *)own;
            if (pixel[-1] == pixel[0] && pixel[2] == pixel[0]) {
                up++;
                own++;
                down++;
                left -= 2;
                continue;
            }
        }
        filter_two(w, out, end - left, width);
        up++;
        own++;
        down++;
        left -= 2;
    }
    filter_pixels(w, out, end - left, end, width);
}

/* What a row has besides the colour that it begins and ends with: columns first..end - 1. */
typedef struct extent {
    uint32_t color; /* of two pixels */
    int32_t first, end;
} extent;

static extent extent_of(const uint16_t *row, int32_t width)
{
    const qtri_pair *words = (const qtri_pair *)(const void *)row;
    const int32_t count = width / 2;
    const uint32_t color = words[0];
    extent e = {color, 0, width};
    if (color != (color << 16 | color >> 16)) {
        return e;
    }
    const qtri_pair *at = words;
    const qtri_pair *end = words + count;
    while (end - at >= 4 &&
           ((at[0] ^ color) | (at[1] ^ color) | (at[2] ^ color) | (at[3] ^ color)) == 0) {
        at += 4;
        QTRI_OPAQUE(at)
    }
    while (at != end && *at == color) {
        at++;
    }
    e.first = 2 * (int32_t)(at - words);
    while (end - at >= 4 &&
           ((end[-1] ^ color) | (end[-2] ^ color) | (end[-3] ^ color) | (end[-4] ^ color)) == 0) {
        end -= 4;
        QTRI_OPAQUE(end)
    }
    while (end != at && end[-1] == color) {
        end--;
    }
    e.end = end == at ? 0 : 2 * (int32_t)(end - words); /* first is the width where that is 0 */
    return e;
}

/* Columns that differ from a neighbour lie in first..end - 1, of a row between two others. */
static extent extent_of_three(const extent *a, const extent *b, const extent *c, int32_t width)
{
    extent e = {b->color, 0, width};
    if (a->color == b->color && b->color == c->color) {
        e.first = qtri_least32(a->first, qtri_least32(b->first, c->first)) - 2;
        e.end = qtri_greatest32(a->end, qtri_greatest32(b->end, c->end)) + 2;
    }
    return e;
}

static bool are_pairs(const qtri_surface *surface)
{
    return (((uintptr_t)surface->pixels | (uintptr_t)surface->pitch) & 3) == 0 &&
           (surface->width & 1) == 0;
}

static void copy_row(uint32_t *to, const uint16_t *row, int32_t width, bool pairs)
{
    if (pairs) {
        const qtri_pair *from = (const qtri_pair *)(const void *)row;
        int32_t left = width / 2;
        for (; left >= 4; left -= 4, to += 4, from += 4) {
            const uint32_t a = from[0];
            const uint32_t b = from[1];
            const uint32_t c = from[2];
            const uint32_t d = from[3];
            to[0] = a;
            to[1] = b;
            to[2] = c;
            to[3] = d;
            QTRI_OPAQUE(to)
        }
        for (; left > 0; left--) {
            *to++ = *from++;
        }
        return;
    }
    uint16_t *pixel = (uint16_t *)(void *)to;
    for (int32_t x = 0; x < width; x++) {
        pixel[x] = row[x];
    }
}

static uint16_t *row_of(const qtri_surface *surface, int32_t y)
{
    return (uint16_t *)(void *)(surface->pixels + (y - surface->first_row) * surface->pitch);
}

/* Row y, whose old colours and those above are kept: columns first..end - 1. */
static void filter_row(const qtri_surface *surface, const window_565 *w, int32_t y, int32_t first,
                       int32_t end, bool pairs)
{
    const int32_t width = surface->width;
    uint16_t *out = row_of(surface, y);
    if (!pairs || end - first < 4) {
        filter_pixels(w, out, first, end, width);
        return;
    }
    const int32_t even = (first + 1) & ~1;
    filter_pixels(w, out, first, even, width);
    filter_pairs(w, out, even, end, width);
}

enum qtri_error qtri_fxaa_565(const qtri_surface *surface, uint32_t *memory, uint32_t words)
{
    const qtri_rect bounds = qtri_surface_bounds(surface);
    const int32_t width = surface->width;
    if (bounds.x0 >= bounds.x1) {
        return QTRI_OK;
    }
    if (!qtri_is_565(surface->format)) {
        return QTRI_ERROR_FORMAT;
    }
    if (words < QTRI_FXAA_565_WORDS(width)) {
        return QTRI_ERROR_MEMORY;
    }
    const bool pairs = are_pairs(surface);
    window_565 w = {{NULL, NULL, NULL, NULL, NULL}};
    extent rows[ROWS] = {{0, 0, width}, {0, 0, width}, {0, 0, width}}; /* above, this, below */
    for (int32_t y = bounds.y0; y < bounds.y1; y++) {
        uint32_t *slot = memory + (ptrdiff_t)(y % ROWS) * ((width + 1) / 2);
        copy_row(slot, row_of(surface, y), width, pairs);
        w.row[0] = w.row[1];
        w.row[1] = w.row[2];
        w.row[2] = (const uint16_t *)(const void *)slot;
        w.row[3] = y + 1 < bounds.y1 ? row_of(surface, y + 1) : NULL;
        w.row[4] = y + 2 < bounds.y1 ? row_of(surface, y + 2) : NULL;
        extent all = {0, 0, width};
        if (pairs) {
            rows[0] = rows[1];
            rows[1] = y == bounds.y0 ? extent_of(w.row[2], width) : rows[2];
            if (w.row[3] != NULL) {
                rows[2] = extent_of(w.row[3], width);
            }
            all = extent_of_three(&rows[0], &rows[1], &rows[2], width);
        }
        if (w.row[1] != NULL && w.row[3] != NULL) {
            filter_row(surface, &w, y, qtri_greatest32(all.first, bounds.x0 > 0 ? bounds.x0 : 1),
                       qtri_least32(all.end, bounds.x1 < width ? bounds.x1 : width - 1), pairs);
        }
    }
    return QTRI_OK;
}
