/* SPDX-License-Identifier: MIT */
/*
 * Gray displays, several pixels a byte. A rectangle of the frame is turned onto the glass, its
 * levels are put into bytes of the panel's memory, and the rows of bytes are sent: from an image of
 * the whole display, or, where there is memory for a few rows only, a few rows at a time.
 */
#include "internal.h"

#include <string.h>

enum { PIECE = 64 }; /* pixels dithered at a time */

/* How pixels lie in bytes, and where bytes lie in the panel's memory. */
typedef struct layout {
    int32_t across_log2, down_log2; /* pixels of a byte */
    int32_t bits;                   /* of a pixel */
    bool high_first;                /* the first pixel in the high bits */
    qtri_rect kept;                 /* bytes that the memory holds: columns and rows */
} layout;

static layout layout_of(qtri_panel_format format)
{
    static const layout gray4 = {1, 0, 4, true, {0, 0, 0, 0}};
    static const layout gray1 = {3, 0, 1, true, {0, 0, 0, 0}};
    static const layout page = {0, 3, 1, false, {0, 0, 0, 0}};
    return format == QTRI_PANEL_GRAY4 ? gray4 : (format == QTRI_PANEL_GRAY1 ? gray1 : page);
}

/* The bytes that a rectangle of pixels touches. */
static qtri_rect bytes_of(const layout *l, qtri_rect pixels)
{
    int32_t across = (1 << l->across_log2) - 1;
    int32_t down = (1 << l->down_log2) - 1;
    qtri_rect bytes = {pixels.x0 >> l->across_log2, pixels.y0 >> l->down_log2,
                       (pixels.x1 + across) >> l->across_log2, (pixels.y1 + down) >> l->down_log2};
    return bytes;
}

/* All pixels of those bytes that are on the glass. */
static qtri_rect pixels_of(const layout *l, qtri_rect bytes, const qtri_panel_description *d)
{
    int32_t right = bytes.x1 << l->across_log2;
    int32_t bottom = bytes.y1 << l->down_log2;
    qtri_rect pixels = {bytes.x0 << l->across_log2, bytes.y0 << l->down_log2,
                        right < d->width ? right : d->width,
                        bottom < d->height ? bottom : d->height};
    return pixels;
}

/* A line on the glass, along x or y: where its pixels lie. */
typedef struct line {
    ptrdiff_t first;     /* byte of position 0, counted from the memory's first */
    ptrdiff_t stride;    /* from a byte to the next */
    int32_t log2;        /* of the pixels that a byte holds along the line */
    uint32_t place;      /* in bytes that hold pixels across it instead */
    uint32_t high_first; /* all bits of a place, or 0 */
    uint32_t bits_log2;
} line;

/* The line through (x, y) along the axis that dx or dy steps along. */
static line line_of(const layout *l, qtri_walk walk)
{
    bool along_x = walk.dx != 0;
    int32_t across = (1 << l->across_log2) - 1;
    int32_t down = (1 << l->down_log2) - 1;
    ptrdiff_t pitch = l->kept.x1 - l->kept.x0;
    int32_t column = (along_x ? 0 : walk.x >> l->across_log2) - l->kept.x0;
    int32_t row = (along_x ? walk.y >> l->down_log2 : 0) - l->kept.y0;
    line result;
    result.first = row * pitch + column;
    result.stride = along_x ? 1 : pitch;
    result.log2 = along_x ? l->across_log2 : l->down_log2;
    result.place = (uint32_t)(along_x ? walk.y & down : walk.x & across);
    result.high_first = l->high_first ? (uint32_t)(across | down) : 0;
    result.bits_log2 = l->bits == 4 ? 2 : 0;
    return result;
}

/* Levels at `at`, at + step, ... of a line; `on` is a copy, which stores of bytes cannot change. */
static void put(line on, uint8_t *memory, int32_t at, int32_t step, const uint8_t *levels,
                int32_t count)
{
    uint32_t within = ((uint32_t)1 << on.log2) - 1;
    uint32_t white = ((uint32_t)1 << (1u << on.bits_log2)) - 1;
    for (int32_t i = 0; i < count; i++) {
        uint8_t *byte = &memory[on.first + (at >> on.log2) * on.stride];
        uint32_t place = (((uint32_t)at & within) + on.place) ^ on.high_first;
        uint32_t shift = place << on.bits_log2;
        *byte = (uint8_t)((*byte & ~(white << shift)) | (uint32_t)levels[i] << shift);
        at += step;
    }
}

/* Levels of a rectangle of the frame, into the memory. */
static void draw(qtri_panel *panel, const layout *l, const qtri_surface *surface, qtri_rect rect)
{
    uint8_t max_level = (uint8_t)((1u << l->bits) - 1);
    for (int32_t y = rect.y0; y < rect.y1; y++) {
        qtri_walk walk = qtri_panel_walk(panel, y);
        int32_t step = walk.dx + walk.dy; /* one of them is 0 */
        int32_t start = walk.dx != 0 ? walk.x : walk.y;
        line on_glass = line_of(l, walk);
        for (int32_t x = rect.x0; x < rect.x1; x += PIECE) {
            uint8_t levels[PIECE];
            int32_t n = rect.x1 - x < PIECE ? rect.x1 - x : PIECE;
            qtri_surface_gray(surface, x, y, n, levels);
            if (panel->diffusion != NULL) {
                qtri_diffuse_row(panel->diffusion, max_level, x, y, levels, n, levels);
            } else {
                qtri_dither_row(panel->dither, max_level, x, y, levels, n, levels);
            }
            put(on_glass, panel->memory, start + x * step, step, levels, n);
        }
    }
}

/*
 * Bytes of the memory, row by row or, where rows touch, all at once. Controllers whose windows are
 * rows get one for each; for the others it is open already.
 */
static enum qtri_error send(qtri_panel *panel, const layout *l, qtri_rect bytes)
{
    bool by_row = panel->description->window_is_row;
    size_t pitch = (size_t)(l->kept.x1 - l->kept.x0);
    size_t width = (size_t)(bytes.x1 - bytes.x0);
    size_t rows = (size_t)(bytes.y1 - bytes.y0);
    const uint8_t *at =
        panel->memory + (size_t)(bytes.y0 - l->kept.y0) * pitch + (size_t)(bytes.x0 - l->kept.x0);
    if (width == pitch && !by_row) {
        return qtri_panel_data(panel, at, width * rows);
    }
    enum qtri_error error = QTRI_OK;
    for (size_t i = 0; i < rows && error == QTRI_OK; i++) {
        qtri_rect row = {bytes.x0, bytes.y0 + (int32_t)i, bytes.x1, bytes.y0 + (int32_t)i + 1};
        error = by_row ? qtri_panel_open(panel, &row) : QTRI_OK;
        error = error == QTRI_OK ? qtri_panel_data(panel, at + i * pitch, width) : error;
    }
    return error;
}

/* Whether the surface, as wide as the frame, has all rows of the rectangle. */
static bool holds_rows(const qtri_surface *surface, const qtri_rect *rect)
{
    return rect->y0 >= surface->first_row && rect->y1 <= surface->first_row + surface->rows;
}

/* Without an image: whole bytes, as many rows of them at a time as the memory holds. */
static enum qtri_error send_rows(qtri_panel *panel, layout *l, const qtri_surface *surface,
                                 qtri_rect bytes)
{
    const qtri_panel_description *d = panel->description;
    qtri_rect whole = qtri_panel_from_glass(panel, pixels_of(l, bytes, d));
    if (panel->diffusion != NULL || !holds_rows(surface, &whole)) {
        return QTRI_ERROR_MEMORY;
    }
    size_t width = (size_t)(bytes.x1 - bytes.x0);
    size_t rows = panel->bytes / width; /* >= 1: the memory holds the widest row */
    enum qtri_error error = d->window_is_row ? QTRI_OK : qtri_panel_open(panel, &bytes);
    for (int32_t y = bytes.y0; y < bytes.y1 && error == QTRI_OK;) {
        int32_t left = bytes.y1 - y;
        l->kept = bytes;
        l->kept.y0 = y;
        l->kept.y1 = y + ((size_t)left < rows ? left : (int32_t)rows);
        error = qtri_panel_finish(panel);
        if (error == QTRI_OK) {
            memset(panel->memory, 0, width * (size_t)(l->kept.y1 - y));
            draw(panel, l, surface, qtri_panel_from_glass(panel, pixels_of(l, l->kept, d)));
            error = send(panel, l, l->kept);
        }
        y = l->kept.y1;
    }
    return error;
}

enum qtri_error qtri_panel_write_gray(qtri_panel *panel, const qtri_surface *surface,
                                      qtri_rect rect)
{
    const qtri_panel_description *d = panel->description;
    layout l = layout_of(d->format);
    qtri_rect glass = {0, 0, d->width, d->height};
    qtri_rect bytes = bytes_of(&l, qtri_panel_to_glass(panel, rect));
    l.kept = bytes_of(&l, glass);
    bytes.x0 &= ~(int32_t)d->window_mask;
    bytes.x1 = (bytes.x1 + d->window_mask) & ~(int32_t)d->window_mask;
    bytes.x1 = bytes.x1 < l.kept.x1 ? bytes.x1 : l.kept.x1;
    if (panel->bytes < (uint32_t)l.kept.x1 * (uint32_t)l.kept.y1) { /* no image */
        return send_rows(panel, &l, surface, bytes);
    }
    draw(panel, &l, surface, rect);
    enum qtri_error error = d->window_is_row ? QTRI_OK : qtri_panel_open(panel, &bytes);
    return error == QTRI_OK ? send(panel, &l, bytes) : error;
}
