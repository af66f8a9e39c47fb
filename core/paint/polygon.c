/* SPDX-License-Identifier: MIT */
#include "paint_checked.h"
#include "path.h"

/* Of few points: sides that are made ready once, and not in every row. */
static void paint_few(const qtri_surface *surface, const qtri_point *point, int32_t count,
                      const qtri_brush *brush)
{
    qtri_path path;
    qtri_path_init(&path);
    const qtri_point *end = &point[count - 1];
    qtri_point last = {qtri_hold_24p8(end->x_24p8), qtri_hold_24p8(end->y_24p8)};
    for (int32_t i = 0; i < count; i++) {
        const qtri_point next = {qtri_hold_24p8(point[i].x_24p8), qtri_hold_24p8(point[i].y_24p8)};
        qtri_path_line(&path, &last, &next);
        last = next;
    }
    qtri_path_paint(&path, surface, brush);
}

#ifdef QTRI_CHECKED
void qtri_paint_polygon(const qtri_surface *surface, const qtri_point *point, int32_t count,
                        const qtri_brush *brush)
{
    qtri_check_points(surface, point, count);
    qtri_paint_polygon_part(surface, point, count, brush);
}
#endif

void qtri_paint_polygon_part(const qtri_surface *surface, const qtri_point *point, int32_t count,
                             const qtri_brush *brush)
{
    if (count >= 3 && count <= QTRI_PATH_EDGES) {
        paint_few(surface, point, count, brush);
    } else if (count >= 3) {
        const qtri_contour contour = {NULL, point, count};
        qtri_paint_contour(surface, &contour, brush);
    }
}
