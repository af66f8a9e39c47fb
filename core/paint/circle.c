/* SPDX-License-Identifier: MIT */
#include "paint_checked.h"
#include "path.h"

static int32_t hold_radius(int32_t radius)
{
    return radius < QTRI_PAINT_RADIUS_MAX_24P8 ? radius : QTRI_PAINT_RADIUS_MAX_24P8;
}

void qtri_paint_circle(const qtri_surface *surface, const qtri_point *center, int32_t radius_24p8,
                       const qtri_brush *brush)
{
    QTRI_CHECK(qtri_check_circle(surface, center, radius_24p8));
    qtri_paint_ring_part(surface, center, radius_24p8, radius_24p8, brush);
}

#ifdef QTRI_CHECKED
void qtri_paint_ring(const qtri_surface *surface, const qtri_point *center, int32_t radius_24p8,
                     int32_t width_24p8, const qtri_brush *brush)
{
    qtri_check_circle(surface, center, radius_24p8);
    qtri_check_ring_width(radius_24p8, width_24p8);
    qtri_paint_ring_part(surface, center, radius_24p8, width_24p8, brush);
}
#endif

void qtri_paint_ring_part(const qtri_surface *surface, const qtri_point *center,
                          int32_t radius_24p8, int32_t width_24p8, const qtri_brush *brush)
{
    if (radius_24p8 <= 0 || width_24p8 <= 0) {
        return;
    }
    const qtri_point held = {qtri_hold_24p8(center->x_24p8), qtri_hold_24p8(center->y_24p8)};
    const int32_t radius = hold_radius(radius_24p8);
    qtri_path path;
    qtri_path_init(&path);
    qtri_path_circle(&path, &held, radius);
    if (width_24p8 < radius) {
        path.direction = -1;
        qtri_path_circle(&path, &held, radius - width_24p8);
    }
    qtri_path_paint(&path, surface, brush);
}
