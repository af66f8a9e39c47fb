#include "fxaa.h"

#include "../frame/barrier.h"

#define NAME(name)      name##_565
#define COLOR           uint16_t
#define LUMA(c)         ((int32_t)(2u * ((c) >> 11) + ((uint32_t)(c) >> 4 & 0x7E) + ((c)&31u)))
#define MIX(w, a, b, s) qtri_mix_565(a, b, s)
#include "fxaa.inc"

enum { ROWS = 3 }; /* old colours that are kept: of this row and two above */

/* Two pixels as a word, which are read as single ones elsewhere. */
#ifdef __GNUC__
typedef uint32_t __attribute__((__may_alias__)) pair;
#else
typedef uint32_t pair;
#endif

static void filter_pixels(const window_565 *w, uint16_t *out, int32_t x, int32_t end, int32_t width)
{
    for (; x < end; x++) {
        out[x] = (uint16_t)filter_565(w, x, width);
    }
}

/*
 * Columns x..end - 1, x even, of rows of whole words: two pixels that are as all their neighbours
 * are done with a look.
 */
QTRI_NOINLINE static void filter_pairs(const window_565 *w, uint16_t *out, int32_t x, int32_t end,
                                       int32_t width)
{
    const pair *up = (const pair *)(const void *)(w->row[1] + x);
    const pair *own = (const pair *)(const void *)(w->row[2] + x);
    const pair *down = (const pair *)(const void *)(w->row[3] + x);
    for (; end - x >= 2; x += 2, up++, own++, down++) {
        const uint32_t two = own[0];
        const uint16_t *pixel = w->row[2] + x;
        if (two == up[0] && two == down[0] && pixel[0] == pixel[-1] && pixel[0] == pixel[1] &&
            pixel[0] == pixel[2]) {
            continue;
        }
        out[x] = (uint16_t)filter_565(w, x, width);
        out[x + 1] = (uint16_t)filter_565(w, x + 1, width);
    }
    filter_pixels(w, out, x, end, width);
}

static bool are_pairs(const qtri_surface *surface)
{
    return (((uintptr_t)surface->pixels | (uintptr_t)surface->pitch) & 3) == 0 &&
           (surface->width & 1) == 0;
}

static void copy_row(uint32_t *to, const uint16_t *row, int32_t width, bool pairs)
{
    if (pairs) {
        const pair *from = (const pair *)(const void *)row;
        for (int32_t i = 0; i < width / 2; i++) {
            to[i] = from[i];
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

/* Row y of the bounds, whose old colours and those above are kept. */
static void filter_row(const qtri_surface *surface, const qtri_rect *bounds, const window_565 *w,
                       int32_t y, bool pairs)
{
    const int32_t width = surface->width;
    const int32_t first = bounds->x0 > 0 ? bounds->x0 : 1;
    const int32_t end = bounds->x1 < width ? bounds->x1 : width - 1;
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
    for (int32_t y = bounds.y0; y < bounds.y1; y++) {
        uint32_t *slot = memory + (ptrdiff_t)(y % ROWS) * ((width + 1) / 2);
        copy_row(slot, row_of(surface, y), width, pairs);
        w.row[0] = w.row[1];
        w.row[1] = w.row[2];
        w.row[2] = (const uint16_t *)(const void *)slot;
        w.row[3] = y + 1 < bounds.y1 ? row_of(surface, y + 1) : NULL;
        w.row[4] = y + 2 < bounds.y1 ? row_of(surface, y + 2) : NULL;
        if (w.row[1] != NULL && w.row[3] != NULL) {
            filter_row(surface, &bounds, &w, y, pairs);
        }
    }
    return QTRI_OK;
}
