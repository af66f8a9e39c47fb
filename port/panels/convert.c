#include "internal.h"

#include <string.h>

bool qtri_panel_is_native(qtri_byte_order order)
{
    const uint16_t one = 1;
    uint8_t first;
    memcpy(&first, &one, 1);
    return order == QTRI_ORDER_NATIVE || order == (first == 1 ? QTRI_ORDER_LITTLE : QTRI_ORDER_BIG);
}

/* value of 0..from as one of 0..to, to nearest. */
static uint32_t scale(uint32_t value, uint32_t from, uint32_t to)
{
    return (value * to + from / 2) / from;
}

static uint32_t to_565(uint32_t r, uint32_t g, uint32_t b)
{
    return scale(r, 255, 31) << 11 | scale(g, 255, 63) << 5 | scale(b, 255, 31);
}

static const uint8_t *row_of(const qtri_surface *surface, int32_t y)
{
    return surface->pixels + (y - surface->first_row) * surface->pitch;
}

void qtri_panel_row_565(const qtri_surface *surface, int32_t x, int32_t y, int32_t count,
                        uint16_t *pixels)
{
    const uint8_t *row = row_of(surface, y);
    if (surface->format == QTRI_RGB565) {
        memcpy(pixels, row + x * (ptrdiff_t)2, (size_t)count * 2);
    } else if (surface->format == QTRI_XRGB8888) {
        const uint32_t *from = (const uint32_t *)(const void *)row + x;
        for (int32_t i = 0; i < count; i++) {
            pixels[i] =
                (uint16_t)to_565((from[i] >> 16) & 255, (from[i] >> 8) & 255, from[i] & 255);
        }
    } else {
        for (int32_t i = 0; i < count; i++) {
            pixels[i] = (uint16_t)to_565(row[x + i], row[x + i], row[x + i]);
        }
    }
}

void qtri_panel_row_8888(const qtri_surface *surface, int32_t x, int32_t y, int32_t count,
                         uint32_t *pixels)
{
    const uint8_t *row = row_of(surface, y);
    if (surface->format == QTRI_RGB565) {
        const uint16_t *from = (const uint16_t *)(const void *)row + x;
        for (int32_t i = 0; i < count; i++) {
            uint32_t c = from[i];
            pixels[i] = scale(c >> 11, 31, 255) << 16 | scale((c >> 5) & 63, 63, 255) << 8 |
                        scale(c & 31, 31, 255);
        }
    } else if (surface->format == QTRI_XRGB8888) {
        const uint32_t *from = (const uint32_t *)(const void *)row + x;
        for (int32_t i = 0; i < count; i++) {
            pixels[i] = from[i] & 0xFFFFFF;
        }
    } else {
        for (int32_t i = 0; i < count; i++) {
            pixels[i] = row[x + i] * (uint32_t)0x010101;
        }
    }
}
