/* SPDX-License-Identifier: MIT */
#include "qtri/surface.h"

#include "../bits/bits.h"
#include "pixel.h"

/* Pixels that a mask has bits for. */
#define MASK_PIXELS 32

/* The word that begins here, or next. */
static uint8_t *align(uint8_t *p)
{
    return p + (0 - (uintptr_t)p) % 4;
}

enum qtri_error qtri_surface_init(qtri_surface *surface, const qtri_format *format, int32_t width,
                                  int32_t height, int32_t first_row, int32_t rows, void *memory,
                                  size_t bytes)
{
    if (width < 1 || width > QTRI_SURFACE_MAX || height < 1 || height > QTRI_SURFACE_MAX ||
        first_row < 0 || first_row >= height || rows < 1 || rows > QTRI_SURFACE_MAX) {
        return QTRI_ERROR_SIZE;
    }
    if (format == NULL) {
        return QTRI_ERROR_FORMAT;
    }
    if (bytes < QTRI_BAND_BYTES(width, rows, format->pixels->bytes)) {
        return QTRI_ERROR_MEMORY;
    }
    size_t pitch = (size_t)width * format->pixels->bytes;
    /* Both at words, for loops that draw pairs: at most 3 + 3 of the 8 bytes to spare. */
    uint8_t *pixels = align((uint8_t *)memory);
    uint8_t *depth = align(pixels + pitch * (size_t)rows);
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

/* Stored to memory that is read as other types. */
#ifdef __GNUC__
typedef uint32_t __attribute__((__may_alias__)) word;
#else
typedef uint32_t word;
#endif

/* Four bytes of pixels or depths, as an aligned word and as its bytes lie in memory. */
typedef union pattern {
    uint32_t word;
    uint8_t byte[4];
} pattern;

enum { BLOCK_BYTES = 64 };

/* end - at is a multiple of BLOCK_BYTES and not 0. */
static void store_blocks(uint8_t *at, const uint8_t *end, uint32_t x)
{
#if defined(__GNUC__) && defined(__thumb__)
    /* GCC 12 stores several registers at once only what it has just loaded so. */
    register uint32_t a __asm__("r3") = x;
    register uint32_t b __asm__("r4") = x;
    register uint32_t c __asm__("r5") = x;
    register uint32_t d __asm__("r6") = x;
    __asm__ volatile("1: stmia %0!, {%1, %2, %3, %4}\n\t"
                     "stmia %0!, {%1, %2, %3, %4}\n\t"
                     "stmia %0!, {%1, %2, %3, %4}\n\t"
                     "stmia %0!, {%1, %2, %3, %4}\n\t"
                     "cmp %0, %5\n\t"
                     "bne 1b"
                     : "+l"(at)
                     : "l"(a), "l"(b), "l"(c), "l"(d), "l"(end)
                     : "cc", "memory");
#else
    for (word *to = (word *)(void *)at; to != (const word *)(const void *)end; to += 4) {
        to[0] = x;
        to[1] = x;
        to[2] = x;
        to[3] = x;
    }
#endif
}

static void fill(uint8_t *at, size_t bytes, const pattern *stored)
{
    uint8_t *end = at + bytes;
    while (at != end) {
        size_t left = (size_t)(end - at);
        if (((uintptr_t)at & 3) != 0 || left < 4) {
            *at = stored->byte[(uintptr_t)at & 3];
            at++;
        } else if (!QTRI_WITH_FAST_PATHS || left < BLOCK_BYTES) {
            *(word *)(void *)at = stored->word;
            at += 4;
        } else {
            left &= ~(size_t)(BLOCK_BYTES - 1);
            store_blocks(at, at + left, stored->word);
            at += left;
        }
    }
}

/* Rows without gaps are one row. `bytes` > 0. */
static void fill_rows(uint8_t *first, ptrdiff_t pitch, size_t bytes, int32_t rows, uint32_t x)
{
    pattern stored = {x};
    if (pitch == (ptrdiff_t)bytes) {
        bytes *= (size_t)rows;
        rows = 1;
    }
    for (int32_t row = 0; row < rows; row++) {
        fill(first + row * pitch, bytes, &stored);
    }
}

/* Where words do not hold whole pixels. */
static void fill_row_of_pixels(const qtri_pixels *pixels, uint8_t *at, int32_t count,
                               uint32_t stored)
{
    for (; count > 0; count -= MASK_PIXELS) {
        pixels->fill(at, stored, UINT32_MAX, count < MASK_PIXELS ? count : MASK_PIXELS);
        at += (ptrdiff_t)pixels->bytes * MASK_PIXELS;
    }
}

void qtri_surface_clear(const qtri_surface *surface, qtri_rgb color, uint16_t depth)
{
    qtri_rect bounds = qtri_surface_bounds(surface);
    if (bounds.x0 == bounds.x1) {
        return;
    }
    int32_t columns = bounds.x1 - bounds.x0;
    int32_t rows = bounds.y1 - bounds.y0;
    ptrdiff_t stored_row = bounds.y0 - surface->first_row;
    const qtri_pixels *pixels = surface->format->pixels;
    const size_t pixel_bytes = pixels->bytes;
    uint8_t *first = surface->pixels + stored_row * surface->pitch +
                     (ptrdiff_t)(pixel_bytes * (size_t)bounds.x0);
    uint32_t pixel = qtri_pixel_from_rgb(surface->format, color);
    if (pixel_bytes == 1 || pixel_bytes == 2 || pixel_bytes == 4) {
        if (pixel_bytes == 1) {
            pixel = (pixel & 0xFF) * 0x101u;
        }
        if (pixel_bytes <= 2) {
            pixel = (pixel & 0xFFFF) * 0x10001u;
        }
        fill_rows(first, surface->pitch, pixel_bytes * (size_t)columns, rows, pixel);
    } else {
        for (int32_t row = 0; row < rows; row++) {
            fill_row_of_pixels(pixels, first + row * surface->pitch, columns, pixel);
        }
    }
    if (surface->depth != NULL) {
        fill_rows((uint8_t *)(surface->depth + stored_row * surface->depth_pitch + bounds.x0),
                  2 * surface->depth_pitch, 2 * (size_t)columns, rows, depth * 0x10001u);
    }
}

qtri_rgb qtri_surface_pixel(const qtri_surface *surface, int32_t x, int32_t y)
{
    qtri_rgb rgb = {0, 0, 0};
    const qtri_format *format = surface->format;
    if (format == NULL || x < 0 || x >= surface->width || y < surface->first_row ||
        (int64_t)y - surface->first_row >= surface->rows) {
        return rgb;
    }
    const uint8_t *row = surface->pixels + (y - surface->first_row) * surface->pitch;
    const qtri_pixels *pixels = format->pixels;
    return qtri_rgb_from_888(format->decode(pixels->load(row + (ptrdiff_t)pixels->bytes * x)));
}

qtri_rect qtri_surface_bounds(const qtri_surface *surface)
{
    static const qtri_rect nothing = {0, 0, 0, 0};
    qtri_rect bounds = surface->scissor;
    int64_t held = (int64_t)surface->first_row + surface->rows;
    int32_t end = held < surface->height ? qtri_saturate32(held) : surface->height;
    bounds.x0 = bounds.x0 > 0 ? bounds.x0 : 0;
    bounds.x1 = bounds.x1 < surface->width ? bounds.x1 : surface->width;
    bounds.y0 = bounds.y0 > surface->first_row ? bounds.y0 : surface->first_row;
    bounds.y0 = bounds.y0 > 0 ? bounds.y0 : 0;
    bounds.y1 = bounds.y1 < end ? bounds.y1 : end;
    const bool is_empty = bounds.x0 >= bounds.x1 || bounds.y0 >= bounds.y1;
    return is_empty || surface->format == NULL ? nothing : bounds;
}
