#include "qtri/surface.h"

#include "../math/bits.h"
#include "../raster/pixel.h"

/* `size` is a power of two. */
static uint8_t *align(uint8_t *p, size_t size)
{
    return p + (size - ((uintptr_t)p & (size - 1))) % size;
}

enum qtri_error qtri_surface_init(qtri_surface *surface, qtri_format format, int32_t width,
                                  int32_t height, int32_t first_row, int32_t rows, void *memory,
                                  size_t bytes)
{
    if (width < 1 || width > QTRI_SURFACE_MAX || height < 1 || height > QTRI_SURFACE_MAX ||
        first_row < 0 || first_row >= height || rows < 1 || rows > QTRI_SURFACE_MAX) {
        return QTRI_ERROR_SIZE;
    }
    if (bytes < QTRI_BAND_BYTES(width, rows, format)) {
        return QTRI_ERROR_MEMORY;
    }
    size_t pitch = (size_t)width * QTRI_FORMAT_BYTES(format);
    uint8_t *pixels = align((uint8_t *)memory, 4); /* at most 3 + 1 of the 8 bytes to spare */
    uint8_t *depth = align(pixels + pitch * (size_t)rows, 2);
    surface->pixels = pixels;
    surface->pitch = (ptrdiff_t)pitch;
    surface->depth = (uint16_t *)(void *)depth;
    surface->depth_pitch = width;
    surface->format = format;
    surface->width = width;
    surface->height = height;
    surface->first_row = first_row;
    surface->rows = rows < height - first_row ? rows : height - first_row;
    qtri_rect frame = {0, 0, width, height};
    surface->scissor = frame;
    return QTRI_OK;
}

void qtri_surface_clear(const qtri_surface *surface, qtri_rgb color, uint16_t depth)
{
    qtri_rect bounds = qtri_surface_bounds(surface);
    uint32_t pixel = qtri_pixel_from_rgb(surface->format, color);
    for (int32_t y = bounds.y0; y < bounds.y1; y++) {
        ptrdiff_t stored_row = y - surface->first_row;
        uint8_t *row = surface->pixels + stored_row * surface->pitch;
        for (int32_t x = bounds.x0; x < bounds.x1; x++) {
            qtri_pixel_store(surface->format, row, x, pixel);
        }
        if (surface->depth != NULL) {
            uint16_t *depth_row = surface->depth + stored_row * surface->depth_pitch;
            for (int32_t x = bounds.x0; x < bounds.x1; x++) {
                depth_row[x] = depth;
            }
        }
    }
}

qtri_rgb qtri_surface_pixel(const qtri_surface *surface, int32_t x, int32_t y)
{
    qtri_rgb rgb = {0, 0, 0};
    if (x < 0 || x >= surface->width || y < surface->first_row ||
        (int64_t)y - surface->first_row >= surface->rows) {
        return rgb;
    }
    const uint8_t *row = surface->pixels + (y - surface->first_row) * surface->pitch;
    return qtri_pixel_widen(surface->format, row, x);
}

qtri_rect qtri_surface_bounds(const qtri_surface *surface)
{
    qtri_rect bounds = surface->scissor;
    int64_t held = (int64_t)surface->first_row + surface->rows;
    int32_t end = held < surface->height ? qtri_saturate32(held) : surface->height;
    bounds.x0 = bounds.x0 > 0 ? bounds.x0 : 0;
    bounds.x1 = bounds.x1 < surface->width ? bounds.x1 : surface->width;
    bounds.y0 = bounds.y0 > surface->first_row ? bounds.y0 : surface->first_row;
    bounds.y0 = bounds.y0 > 0 ? bounds.y0 : 0;
    bounds.y1 = bounds.y1 < end ? bounds.y1 : end;
    return bounds;
}
