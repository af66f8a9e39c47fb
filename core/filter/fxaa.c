/* SPDX-License-Identifier: MIT */
#include "fxaa.h"

#include "qtri/error.h"

const uint16_t qtri_fxaa_inverses[2 * QTRI_FXAA_REACH + 1] = {
    0,    0,    32768, 21845, 16384, 13107, 10923, 9362, 8192, 7282, 6554, 5958, 5461,
    5041, 4681, 4369,  4096,  3855,  3641,  3449,  3277, 3121, 2979, 2849, 2731};

/* ---- Any format: rows are decoded, with their luma in the high byte ---- */

enum { LUMA_SHIFT = 24, ROWS = 5 };

/* Weights 2 4 1, of 565 without a multiplication: 0..223 as (2 r + 4 g + b) / 8 of 8 bits. */
static uint32_t luma_of(const qtri_colors *kind, uint32_t color)
{
    if (kind->single) {
        return (color & 0xFF) * 7 >> 3;
    }
    if (kind->red == 11) {
        return 2 * (color >> 11) + (color >> 4 & 0x7E) + (color & 31);
    }
    return (2 * (color >> 16 & 0xFF) + 4 * (color >> 8 & 0xFF) + (color & 0xFF)) >> 3;
}

static const qtri_colors *kind_of(const void *window);

#define NAME(name)      name##_any
#define COLOR           uint32_t
#define LUMA(c)         ((int32_t)((c) >> LUMA_SHIFT))
#define MIX(w, a, b, s) qtri_mix_colors(kind_of(w), a, b, s)
#define LUMA_ROWS
#define LIGHT                uint32_t
#define LIGHTS(w, i)         ((w)->row[i])
#define LUMAS(w, i, x, side) (LUMA((w)->row[i][x]) + LUMA((w)->row[i][(x) + (side)]))
#include "fxaa.inc"

/* A window that knows its kind of colour. */
typedef struct kind_window {
    window_any window;
    const qtri_colors *kind;
} kind_window;

static const qtri_colors *kind_of(const void *window)
{
    const kind_window *w = window;
    return w->kind;
}

static void decode_row(const qtri_surface *surface, int32_t y, uint32_t *out)
{
    const qtri_format *format = surface->format;
    const uint8_t *pixel = surface->pixels + (y - surface->first_row) * surface->pitch;
    for (int32_t x = 0; x < surface->width; x++) {
        const uint32_t color = qtri_color_of(format, format->pixels->load(pixel));
        out[x] = color | luma_of(format->colors, color) << LUMA_SHIFT;
        pixel += format->pixels->bytes;
    }
}

enum qtri_error qtri_fxaa(const qtri_surface *surface, uint32_t *memory, uint32_t words)
{
    QTRI_ASSERT(memory != NULL || words == 0);
    const qtri_rect bounds = qtri_surface_bounds(surface);
    const int32_t width = surface->width;
    if (bounds.x0 >= bounds.x1) {
        return QTRI_OK;
    }
    if (memory == NULL || words < QTRI_FXAA_WORDS(width)) {
        return QTRI_ERROR_MEMORY;
    }
    const qtri_format *format = surface->format;
    const int32_t first = bounds.x0 > 0 ? bounds.x0 : 1;
    const int32_t end = bounds.x1 < width ? bounds.x1 : width - 1;
    kind_window w = {{{NULL, NULL, NULL, NULL, NULL}}, format->colors};
    for (int32_t y = bounds.y0 - 2; y < bounds.y1; y++) {
        /* Row y + 2 comes in, while it is as it was; y - 3 goes. */
        uint32_t *slot = memory + (ptrdiff_t)((y + 2) % ROWS) * width;
        for (int i = 0; i < ROWS - 1; i++) {
            w.window.row[i] = w.window.row[i + 1];
        }
        w.window.row[ROWS - 1] = NULL;
        if (y + 2 < bounds.y1) {
            decode_row(surface, y + 2, slot);
            w.window.row[ROWS - 1] = slot;
        }
        if (w.window.row[1] == NULL || w.window.row[3] == NULL) { /* between two there is one */
            continue;
        }
        uint8_t *row = surface->pixels + (y - surface->first_row) * surface->pitch;
        for (int32_t x = first; x < end; x++) {
            const uint32_t old = w.window.row[2][x];
            const uint32_t color = filter_any(&w.window, x, width);
            if (color != old) {
                const uint32_t stored = qtri_stored_of(format, color & 0xFFFFFF);
                format->pixels->store(row + x * (ptrdiff_t)format->pixels->bytes, &stored, 1, 1);
            }
        }
    }
    return QTRI_OK;
}
