/* SPDX-License-Identifier: MIT */
#include "internal.h"

#include <string.h>

bool qtri_panel_is_native(qtri_byte_order order)
{
    const uint16_t one = 1;
    uint8_t first;
    memcpy(&first, &one, 1);
    return order == QTRI_ORDER_NATIVE || (order == QTRI_ORDER_LITTLE) == (first == 1);
}

/* 31 / 255 and 63 / 255 of a channel, to nearest for all 256: a Cortex-M0+ has no division. */
static uint32_t to_565(uint32_t r, uint32_t g, uint32_t b)
{
    return (r * 249 + 1014) >> 11 << 11 | (g * 253 + 505) >> 10 << 5 | (b * 249 + 1014) >> 11;
}

/* The first of pixels (x, y) .. in memory. */
static const uint8_t *at(const qtri_surface *surface, int32_t x, int32_t y)
{
    return surface->pixels + (y - surface->first_row) * surface->pitch +
           (ptrdiff_t)surface->format->pixels->bytes * x;
}

bool qtri_panel_is_565(const qtri_surface *surface)
{
    return surface->format->decode == qtri_decode_rgb565 && surface->format->pixels->bytes == 2;
}

bool qtri_panel_is_swapped_565(const qtri_surface *surface)
{
    return surface->format->decode == qtri_decode_rgb565_swapped &&
           surface->format->pixels->bytes == 2;
}

bool qtri_panel_is_in_place(const qtri_surface *surface, qtri_byte_order order)
{
    return qtri_panel_is_native(order) ? qtri_panel_is_565(surface)
                                       : qtri_panel_is_swapped_565(surface);
}

void qtri_panel_row_565(const qtri_panel *panel, const qtri_surface *surface, int32_t x, int32_t y,
                        int32_t count, uint16_t *pixels)
{
    const qtri_format *format = surface->format;
    const uint8_t *from = at(surface, x, y);
    if (qtri_panel_is_565(surface)) {
        memcpy(pixels, from, (size_t)count * 2);
    } else if (qtri_panel_is_swapped_565(surface)) {
        const uint16_t *swapped = (const uint16_t *)(const void *)from;
        for (int32_t i = 0; i < count; i++) {
            pixels[i] = (uint16_t)(swapped[i] << 8 | swapped[i] >> 8);
        }
    } else if (panel->dither_565 != NULL) {
        uint32_t rgb[QTRI_PANEL_PIECE];
        qtri_panel_row_8888(surface, x, y, count, rgb);
        panel->dither_565(panel->dither, x, y, rgb, count, pixels);
    } else {
        for (int32_t i = 0; i < count; i++, from += format->pixels->bytes) {
            uint32_t c = format->decode(format->pixels->load(from));
            pixels[i] = (uint16_t)to_565((c >> 16) & 255, (c >> 8) & 255, c & 255);
        }
    }
}

void qtri_panel_row_8888(const qtri_surface *surface, int32_t x, int32_t y, int32_t count,
                         uint32_t *pixels)
{
    const qtri_format *format = surface->format;
    const uint8_t *from = at(surface, x, y);
    for (int32_t i = 0; i < count; i++, from += format->pixels->bytes) {
        pixels[i] = format->decode(format->pixels->load(from));
    }
}
