/* SPDX-License-Identifier: MIT */
#include "ink.h"

void qtri_paint_polygon(const qtri_surface *surface, const qtri_point *point, int32_t count,
                        const qtri_brush *brush)
{
    if (count >= 3) {
        const qtri_contour contour = {NULL, point, count};
        qtri_paint_contour(surface, &contour, brush);
    }
}
