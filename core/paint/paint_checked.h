/* SPDX-License-Identifier: MIT */
/*
 * Checks of coordinates in 1/256 pixel, for checked builds: plain pixels, QTRI_PX() forgotten.
 * Internal.
 *
 * What is painted with plain pixels is thinner than one, and lies in the frame's first corner, as
 * far from it in 1/256 pixel as the frame has pixels. What is meant so has its ends on whole or
 * half pixels, or is cut off by the frame's side.
 */
#ifndef QTRI_PAINT_CHECKED_H
#define QTRI_PAINT_CHECKED_H

#include <stdbool.h>

#include "qtri/paint.h"

#include "../bits/bits.h"

#ifdef QTRI_CHECKED

/* Below 1/16 pixel a width is hardly seen. */
enum { QTRI_PLAIN_WIDTH_MAX_24P8 = 15 };

static inline bool qtri_is_plain_area(const qtri_surface *surface, const qtri_area *box,
                                      int32_t finest)
{
    const int64_t width = (int64_t)box->x1_24p8 - box->x0_24p8;
    const int64_t height = (int64_t)box->y1_24p8 - box->y0_24p8;
    const bool is_thin = width < 256 || height < 256;
    const bool is_first = box->x0_24p8 >= 0 && box->x1_24p8 <= surface->width &&
                          box->y0_24p8 >= 0 && box->y1_24p8 <= surface->height;
    return is_thin && is_first && (finest & 127) != 0;
}

/* An area without an inside is none. */
static inline void qtri_check_area(const qtri_surface *surface, const qtri_area *box)
{
    QTRI_ASSERT(surface != NULL);
    QTRI_ASSERT(box != NULL);
    const bool is_empty = box->x0_24p8 >= box->x1_24p8 || box->y0_24p8 >= box->y1_24p8;
    const int32_t finest = box->x0_24p8 | box->y0_24p8 | box->x1_24p8 | box->y1_24p8;
    QTRI_ASSERT(is_empty || !qtri_is_plain_area(surface, box, finest));
}

static inline void qtri_check_circle(const qtri_surface *surface, const qtri_point *center,
                                     int32_t radius)
{
    QTRI_ASSERT(surface != NULL);
    QTRI_ASSERT(center != NULL);
    if (radius <= 0 || radius > QTRI_SURFACE_MAX || center->x_24p8 < radius ||
        center->y_24p8 < radius || center->x_24p8 > QTRI_SURFACE_MAX ||
        center->y_24p8 > QTRI_SURFACE_MAX) {
        return;
    }
    const qtri_area box = {center->x_24p8 - radius, center->y_24p8 - radius,
                           center->x_24p8 + radius, center->y_24p8 + radius};
    QTRI_ASSERT(!qtri_is_plain_area(surface, &box, center->x_24p8 | center->y_24p8 | radius));
}

static inline void qtri_check_points(const qtri_surface *surface, const qtri_point *point,
                                     int32_t count)
{
    QTRI_ASSERT(surface != NULL);
    QTRI_ASSERT(point != NULL || count <= 0);
    qtri_area box = {INT32_MAX, INT32_MAX, INT32_MIN, INT32_MIN};
    int32_t finest = 0;
    for (int32_t i = 0; i < count; i++) {
        const qtri_point p = point[i];
        box.x0_24p8 = p.x_24p8 < box.x0_24p8 ? p.x_24p8 : box.x0_24p8;
        box.y0_24p8 = p.y_24p8 < box.y0_24p8 ? p.y_24p8 : box.y0_24p8;
        box.x1_24p8 = p.x_24p8 > box.x1_24p8 ? p.x_24p8 : box.x1_24p8;
        box.y1_24p8 = p.y_24p8 > box.y1_24p8 ? p.y_24p8 : box.y1_24p8;
        finest |= p.x_24p8 | p.y_24p8;
    }
    const bool is_point = box.x0_24p8 == box.x1_24p8 && box.y0_24p8 == box.y1_24p8;
    QTRI_ASSERT(count <= 0 || is_point || !qtri_is_plain_area(surface, &box, finest));
}

/* None paints nothing. */
static inline void qtri_check_width(int32_t width_24p8)
{
    QTRI_ASSERT(width_24p8 <= 0 || width_24p8 > QTRI_PLAIN_WIDTH_MAX_24P8);
}

/* As wide as the radius it is a circle, or a slice of one. */
static inline void qtri_check_ring_width(int32_t radius_24p8, int32_t width_24p8)
{
    qtri_check_width(width_24p8 < radius_24p8 ? width_24p8 : 0);
}

/* What was checked as it was given, or is a part of that. */
void qtri_paint_rect_part(const qtri_surface *surface, const qtri_area *box,
                          const qtri_brush *brush);
void qtri_paint_ring_part(const qtri_surface *surface, const qtri_point *center,
                          int32_t radius_24p8, int32_t width_24p8, const qtri_brush *brush);
void qtri_paint_polygon_part(const qtri_surface *surface, const qtri_point *point, int32_t count,
                             const qtri_brush *brush);
#else
#define qtri_paint_rect_part    qtri_paint_rect
#define qtri_paint_ring_part    qtri_paint_ring
#define qtri_paint_polygon_part qtri_paint_polygon
#endif

#endif
