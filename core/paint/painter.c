/* SPDX-License-Identifier: MIT */
#include "ink.h"

#include "../frame/fill.h"

bool qtri_painter_begin(qtri_painter *painter, const qtri_surface *surface, const qtri_brush *brush)
{
    QTRI_ASSERT(brush != NULL);
    painter->surface = surface;
    painter->ink = brush->ink;
    painter->bounds = qtri_surface_bounds(surface);
    painter->alpha = brush->ink != NULL ? brush->alpha : 255;
    if (painter->bounds.x0 == painter->bounds.x1 || painter->alpha == 0) {
        return false;
    }
    painter->stored = qtri_pixel_from_rgb(surface->format, brush->color);
    if (brush->ink != NULL) {
        painter->color_888 =
            (uint32_t)brush->color.r << 16 | (uint32_t)brush->color.g << 8 | brush->color.b;
        const int32_t color_8p16[3] = {(int32_t)brush->color.r << 16, (int32_t)brush->color.g << 16,
                                       (int32_t)brush->color.b << 16};
        painter->channels = qtri_channels_from_color(surface->format->colors, color_8p16);
    }
    return true;
}

uint8_t *qtri_painter_at(const qtri_painter *painter, int32_t x, int32_t row)
{
    const qtri_surface *surface = painter->surface;
    return surface->pixels + (ptrdiff_t)(row - surface->first_row) * surface->pitch +
           (ptrdiff_t)surface->format->pixels->bytes * x;
}

static bool is_opaque(const qtri_painter *painter, uint32_t coverage)
{
    return painter->ink == NULL || (painter->alpha & coverage) == 255;
}

void qtri_painter_span(const qtri_painter *painter, int32_t row, int32_t x0, int32_t x1,
                       uint32_t coverage)
{
    x0 = x0 > painter->bounds.x0 ? x0 : painter->bounds.x0;
    x1 = x1 < painter->bounds.x1 ? x1 : painter->bounds.x1;
    if (x0 >= x1) {
        return;
    }
    if (is_opaque(painter, coverage)) {
        const qtri_rect rect = {x0, row, x1, row + 1};
        qtri_fill_rect(painter->surface, &rect, painter->stored);
    } else {
        painter->ink->span(painter, qtri_painter_at(painter, x0, row), x1 - x0, coverage);
    }
}

void qtri_painter_rect(const qtri_painter *painter, const qtri_rect *rect)
{
    const qtri_rect *bounds = &painter->bounds;
    const qtri_rect r = {rect->x0 > bounds->x0 ? rect->x0 : bounds->x0,
                         rect->y0 > bounds->y0 ? rect->y0 : bounds->y0,
                         rect->x1 < bounds->x1 ? rect->x1 : bounds->x1,
                         rect->y1 < bounds->y1 ? rect->y1 : bounds->y1};
    if (r.x0 >= r.x1 || r.y0 >= r.y1) {
        return;
    }
    if (is_opaque(painter, 255)) {
        qtri_fill_rect(painter->surface, &r, painter->stored);
        return;
    }
    for (int32_t row = r.y0; row < r.y1; row++) {
        painter->ink->span(painter, qtri_painter_at(painter, r.x0, row), r.x1 - r.x0, 255);
    }
}

void qtri_hard_rect(const qtri_painter *painter, const qtri_area *box)
{
    const qtri_rect rect = {qtri_pixel_from(box->x0_24p8), qtri_pixel_from(box->y0_24p8),
                            qtri_pixel_from(box->x1_24p8), qtri_pixel_from(box->y1_24p8)};
    qtri_painter_rect(painter, &rect);
}
