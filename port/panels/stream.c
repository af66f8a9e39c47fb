/* SPDX-License-Identifier: MIT */
/* Colours over a bus: whole pixels, row by row, into a window of the controller's memory. */
#include "internal.h"

/* count pixels into bytes. RGB565 surfaces are read in place. */
static void convert(const qtri_panel *panel, const qtri_surface *surface, int32_t x, int32_t y,
                    int32_t count, uint8_t *bytes)
{
    qtri_byte_order order = panel->description->order;
    bool low_first = order == QTRI_ORDER_NATIVE ? qtri_panel_is_native(QTRI_ORDER_LITTLE)
                                                : order == QTRI_ORDER_LITTLE;
    uint16_t piece[QTRI_PANEL_PIECE];
    while (count > 0) {
        const uint16_t *pixels = piece;
        int32_t n = count;
        if (qtri_panel_is_565(surface)) {
            pixels = (const uint16_t *)(const void *)(surface->pixels +
                                                      (y - surface->first_row) * surface->pitch) +
                     x;
        } else {
            n = n < QTRI_PANEL_PIECE ? n : QTRI_PANEL_PIECE;
            qtri_panel_row_565(panel, surface, x, y, n, piece);
        }
        uint8_t *low = bytes + (low_first ? 0 : 1);
        uint8_t *high = bytes + (low_first ? 1 : 0);
        for (int32_t i = 0; i < n; i++) {
            low[2 * i] = (uint8_t)pixels[i];
            high[2 * i] = (uint8_t)(pixels[i] >> 8);
        }
        bytes += (size_t)n * 2;
        x += n;
        count -= n;
    }
}

/* What is in the display's order already goes as it lies: all rows at once where they touch. */
static enum qtri_error send_in_place(qtri_panel *panel, const qtri_surface *surface, qtri_rect rect)
{
    const uint8_t *row =
        surface->pixels + (rect.y0 - surface->first_row) * surface->pitch + rect.x0 * (ptrdiff_t)2;
    size_t row_bytes = (size_t)(rect.x1 - rect.x0) * 2;
    int32_t rows = rect.y1 - rect.y0;
    if (surface->pitch == (ptrdiff_t)row_bytes) {
        return qtri_panel_data(panel, row, row_bytes * (size_t)rows);
    }
    enum qtri_error error = QTRI_OK;
    for (int32_t y = 0; y < rows && error == QTRI_OK; y++) {
        error = qtri_panel_data(panel, row + y * surface->pitch, row_bytes);
    }
    return error;
}

enum qtri_error qtri_panel_write_565(qtri_panel *panel, const qtri_surface *surface, qtri_rect rect)
{
    enum qtri_error error = panel->description->window(panel, &rect);
    if (error == QTRI_OK && qtri_panel_is_in_place(surface, panel->description->order)) {
        return send_in_place(panel, surface, rect);
    }
    /* The memory's halves in turn: one is filled while the other is sent. Both hold whole pixels.
     */
    size_t half = panel->bytes / 4 * 2;
    uint8_t *buffer = panel->memory;
    size_t filled = 0;
    for (int32_t y = rect.y0; y < rect.y1 && error == QTRI_OK; y++) {
        for (int32_t x = rect.x0; x < rect.x1 && error == QTRI_OK;) {
            size_t room = (half - filled) / 2;
            int32_t left = rect.x1 - x;
            int32_t n = (size_t)left < room ? left : (int32_t)room;
            convert(panel, surface, x, y, n, buffer + filled);
            filled += (size_t)n * 2;
            x += n;
            if (filled == half || y == rect.y1 - 1) { /* full, or all of the last row */
                error = qtri_panel_data(panel, buffer, filled);
                buffer = buffer == panel->memory ? panel->memory + half : panel->memory;
                filled = 0;
            }
        }
    }
    return error;
}

/* Six bits of each channel, to nearest, as the high ones of a byte. */
static void convert_666(const qtri_surface *surface, int32_t x, int32_t y, int32_t count,
                        uint8_t *bytes)
{
    while (count > 0) {
        uint32_t piece[QTRI_PANEL_PIECE];
        const int32_t n = count < QTRI_PANEL_PIECE ? count : QTRI_PANEL_PIECE;
        qtri_panel_row_8888(surface, x, y, n, piece);
        for (int32_t i = 0; i < n; i++, bytes += 3) {
            for (int32_t c = 0; c < 3; c++) {
                const uint32_t channel = piece[i] >> (16 - 8 * c) & 255;
                bytes[c] = (uint8_t)((channel * 253 + 505) >> 10 << 2); /* 63 / 255, all 256 */
            }
        }
        x += n;
        count -= n;
    }
}

/* The memory's halves in turn, a row or what they hold of it at a time. */
enum qtri_error qtri_panel_write_666(qtri_panel *panel, const qtri_surface *surface, qtri_rect rect)
{
    enum qtri_error error = panel->description->window(panel, &rect);
    const size_t half = panel->bytes / 6; /* pixels; >= 1 */
    const int32_t most = half < 8192 ? (int32_t)half : 8192;
    bool is_second = false;
    for (int32_t y = rect.y0; y < rect.y1 && error == QTRI_OK; y++) {
        for (int32_t x = rect.x0; x < rect.x1 && error == QTRI_OK; x += most) {
            const int32_t n = rect.x1 - x < most ? rect.x1 - x : most;
            uint8_t *buffer = panel->memory + (is_second ? 3 * half : 0);
            convert_666(surface, x, y, n, buffer);
            error = qtri_panel_data(panel, buffer, (size_t)n * 3);
            is_second = !is_second;
        }
    }
    return error;
}
