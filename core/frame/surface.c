/* SPDX-License-Identifier: MIT */
/* Surfaces: set up, cleared and read. */
#include "qtri/surface.h"

#include "../bits/bits.h"
#include "depth_format.h"
#include "pixel.h"

/* Rounds up to a multiple of four. */
static uint8_t *align(uint8_t *p)
{
    return p + (0 - (uintptr_t)p) % 4;
}

/* Makes it a surface on which nothing is drawn; returns the error. */
static enum qtri_error refuse(qtri_surface *surface, enum qtri_error error)
{
    static const qtri_surface nothing;
    *surface = nothing;
    return error;
}

enum qtri_error qtri_surface_init(qtri_surface *surface, const qtri_format *format, int32_t width,
                                  int32_t height, int32_t first_row, int32_t rows, void *memory,
                                  size_t bytes)
{
    QTRI_ASSERT(surface != NULL);
    QTRI_CHECK(qtri_check_format(format));
    if (width < 1 || width > QTRI_SURFACE_MAX || height < 1 || height > QTRI_SURFACE_MAX ||
        first_row < 0 || first_row >= height || rows < 1 || rows > QTRI_SURFACE_MAX) {
        return refuse(surface, QTRI_ERROR_SIZE);
    }
    if (format == NULL) {
        return refuse(surface, QTRI_ERROR_FORMAT);
    }
    if (memory == NULL || bytes < QTRI_BAND_BYTES(width, rows, format->pixels->bytes)) {
        return refuse(surface, QTRI_ERROR_MEMORY);
    }
    size_t pitch = (size_t)width * format->pixels->bytes;
    /* Both at words, for loops that draw pairs: at most 3 + 3 of the 8 bytes to spare. */
    uint8_t *pixels = align((uint8_t *)memory);
    uint8_t *depth = align(pixels + pitch * (size_t)rows);
    surface->pixels = pixels;
    surface->pitch = (ptrdiff_t)pitch;
    surface->depth = (uint16_t *)(void *)depth;
    surface->depth_pitch = width;
    surface->depth_format = NULL;
    surface->format = format;
    surface->width = width;
    surface->height = height;
    surface->first_row = first_row;
    surface->rows = rows < height - first_row ? rows : height - first_row;
    qtri_rect frame = {0, 0, width, height};
    surface->scissor = frame;
    return QTRI_OK;
}

enum qtri_error qtri_surface_set_depth(qtri_surface *surface, const qtri_depth_format *format,
                                       size_t bytes)
{
    QTRI_ASSERT(surface != NULL);
    QTRI_CHECK(qtri_check_depth_format(format));
    if (surface->format == NULL || !qtri_depth_goes_with(format, surface->format)) {
        return refuse(surface, QTRI_ERROR_FORMAT);
    }
    const size_t pixel_bytes = (size_t)((uint8_t *)surface->depth - surface->pixels);
    const size_t depth_bytes =
        (size_t)surface->width * (size_t)surface->rows * (size_t)qtri_depth_bytes(format);
    if (bytes < pixel_bytes + depth_bytes + 3) { /* to align the pixels */
        return refuse(surface, QTRI_ERROR_MEMORY);
    }
    surface->depth_format = format;
    return QTRI_OK;
}

/* Fills a rectangle, which is not empty, with a depth 0..65535.0. */
static inline void fill_depth(const qtri_surface *surface, const qtri_rect *rect,
                              uint32_t depth_16p16)
{
    const qtri_depth_ops *ops = qtri_depth_ops_of(surface);
    if (ops != NULL) {
        ops->fill(surface, rect, depth_16p16);
        return;
    }
    const ptrdiff_t stored_row = rect->y0 - surface->first_row;
    qtri_fill_words((uint8_t *)(surface->depth + stored_row * surface->depth_pitch + rect->x0),
                    2 * surface->depth_pitch, 2 * (size_t)(rect->x1 - rect->x0),
                    rect->y1 - rect->y0, ((depth_16p16 + 0x8000) >> 16) * 0x10001u);
}

void qtri_surface_clear(const qtri_surface *surface, qtri_rgb color)
{
    QTRI_ASSERT(surface != NULL);
    qtri_rect bounds = qtri_surface_bounds(surface);
    if (bounds.x0 == bounds.x1) {
        return;
    }
    qtri_fill_rect(surface, &bounds, qtri_pixel_from_rgb(surface->format, color));
    if (surface->depth != NULL) {
        fill_depth(surface, &bounds, (uint32_t)65535 << 16);
    }
}

void qtri_surface_clear_depth(const qtri_surface *surface, q16 depth)
{
    QTRI_ASSERT(depth >= 0 && depth != 1 && depth <= Q16_ONE);
    QTRI_ASSERT(surface != NULL);
    const qtri_rect bounds = qtri_surface_bounds(surface);
    if (bounds.x0 != bounds.x1 && surface->depth != NULL) {
        fill_depth(surface, &bounds, 65535u * (uint32_t)qtri_hold32(depth, 0, Q16_ONE));
    }
}

qtri_rgb qtri_surface_pixel(const qtri_surface *surface, int32_t x, int32_t y)
{
    QTRI_ASSERT(surface != NULL);
    qtri_rgb rgb = {0, 0, 0};
    const qtri_format *format = surface->format;
    if (format == NULL || x < 0 || x >= surface->width || y < surface->first_row ||
        (int64_t)y - surface->first_row >= surface->rows) {
        return rgb;
    }
    const uint32_t color = format->decode(format->pixels->load(qtri_surface_at(surface, x, y)));
    rgb.r = (uint8_t)(color >> 16);
    rgb.g = (uint8_t)(color >> 8);
    rgb.b = (uint8_t)color;
    return rgb;
}

qtri_rect qtri_surface_bounds(const qtri_surface *surface)
{
    QTRI_ASSERT(surface != NULL);
    static const qtri_rect nothing = {0, 0, 0, 0};
    qtri_rect bounds = surface->scissor;
    const int32_t width = qtri_least32(surface->width, QTRI_SURFACE_MAX);
    const int32_t height = qtri_least32(surface->height, QTRI_SURFACE_MAX);
    int64_t held = (int64_t)surface->first_row + surface->rows;
    int32_t end = held < height ? qtri_saturate32(held) : height;
    bounds.x0 = bounds.x0 > 0 ? bounds.x0 : 0;
    bounds.x1 = bounds.x1 < width ? bounds.x1 : width;
    bounds.y0 = bounds.y0 > surface->first_row ? bounds.y0 : surface->first_row;
    bounds.y0 = bounds.y0 > 0 ? bounds.y0 : 0;
    bounds.y1 = bounds.y1 < end ? bounds.y1 : end;
    return qtri_rect_is_empty(&bounds) || surface->format == NULL ? nothing : bounds;
}
