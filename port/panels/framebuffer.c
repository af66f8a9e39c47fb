/* SPDX-License-Identifier: MIT */
/* Memory-mapped displays: pixels are stored where the display controller reads them. */
#include "internal.h"

#include <string.h>

/* Bytes one by one: a framebuffer is aligned as it may be. */
static void store_bytes(uint8_t *at, uint32_t pixel, int32_t bytes, bool low_first)
{
    uint8_t *to = low_first ? at : at + bytes - 1;
    const int32_t step = low_first ? 1 : -1;
    for (; bytes > 0; bytes--) {
        *to = (uint8_t)pixel;
        to += step;
        pixel >>= 8;
    }
}

static void store_halves(const uint16_t *pixel, int32_t count, uint8_t *at, ptrdiff_t step,
                         bool low_first)
{
    uint8_t *low = at + (low_first ? 0 : 1);
    uint8_t *high = at + (low_first ? 1 : 0);
    for (const uint16_t *end = pixel + count; pixel != end; pixel++) {
        *low = (uint8_t)*pixel;
        *high = (uint8_t)(*pixel >> 8);
        low += step;
        high += step;
    }
}

/* One piece of a row. step: bytes from a pixel to the next one in the frame's row. */
static void store_piece(const qtri_panel *panel, const qtri_surface *surface, int32_t x, int32_t y,
                        int32_t count, uint8_t *at, ptrdiff_t step)
{
    const qtri_byte_order order = panel->description->order;
    const bool native = qtri_panel_is_native(order);
    const bool low_first = native == qtri_panel_is_native(QTRI_ORDER_LITTLE);
    if (panel->description->format == QTRI_PANEL_RGB565) {
        uint16_t pixels[QTRI_PANEL_PIECE];
        qtri_panel_row_565(panel, surface, x, y, count, pixels);
        store_halves(pixels, count, at, step, low_first);
    } else {
        uint32_t pixels[QTRI_PANEL_PIECE];
        qtri_panel_row_8888(surface, x, y, count, pixels);
        for (int32_t i = 0; i < count; i++, at += step) {
            store_bytes(at, pixels[i], 4, low_first);
        }
    }
}

enum qtri_error qtri_panel_write_mapped(qtri_panel *panel, const qtri_surface *surface,
                                        qtri_rect rect)
{
    const qtri_panel_description *d = panel->description;
    ptrdiff_t pixel = d->format == QTRI_PANEL_RGB565 ? 2 : 4;
    ptrdiff_t pitch = d->pitch != 0 ? (ptrdiff_t)d->pitch : (ptrdiff_t)d->width * pixel;
    bool copies = panel->rotation == QTRI_ROTATE_0 && d->format == QTRI_PANEL_RGB565 &&
                  qtri_panel_is_in_place(surface, d->order);
    for (int32_t y = rect.y0; y < rect.y1; y++) {
        qtri_walk walk = qtri_panel_walk(panel, y);
        ptrdiff_t step = (ptrdiff_t)walk.dx * pixel + (ptrdiff_t)walk.dy * pitch;
        uint8_t *at = panel->memory + walk.y * pitch + walk.x * pixel + rect.x0 * step;
        if (copies) {
            const uint8_t *row = surface->pixels + (y - surface->first_row) * surface->pitch;
            memcpy(at, row + rect.x0 * pixel, (size_t)((rect.x1 - rect.x0) * pixel));
            continue;
        }
        for (int32_t x = rect.x0; x < rect.x1; x += QTRI_PANEL_PIECE) {
            int32_t n = rect.x1 - x < QTRI_PANEL_PIECE ? rect.x1 - x : QTRI_PANEL_PIECE;
            store_piece(panel, surface, x, y, n, at, step);
            at += n * step;
        }
    }
    return QTRI_OK;
}
