/*
 * Formats by number, for loops that are made for a few of them. Internal, and on its way out: what
 * asks for a kind is to go through the description.
 */
#ifndef QTRI_FRAME_KIND_H
#define QTRI_FRAME_KIND_H

#include <stdbool.h>

#include "qtri/surface.h"

typedef enum qtri_kind { QTRI_KIND_RGB565, QTRI_KIND_XRGB8888, QTRI_KIND_GRAY8 } qtri_kind;

/* Others count as XRGB8888, but nothing is drawn on them: see qtri_drawn_bounds. */
static inline qtri_kind qtri_kind_of(const qtri_surface *surface)
{
    if (surface->format == &qtri_rgb565) {
        return QTRI_KIND_RGB565;
    }
    return surface->format == &qtri_gray8 ? QTRI_KIND_GRAY8 : QTRI_KIND_XRGB8888;
}

/* qtri_surface_bounds, and nothing for surfaces that can only be cleared. */
static inline qtri_rect qtri_drawn_bounds(const qtri_surface *surface)
{
    const qtri_rect nothing = {0, 0, 0, 0};
    const bool is_drawn = surface->format == &qtri_rgb565 || surface->format == &qtri_xrgb8888 ||
                          surface->format == &qtri_gray8;
    return is_drawn ? qtri_surface_bounds(surface) : nothing;
}

#endif
