/* SPDX-License-Identifier: MIT */
#include "path.h"

void qtri_path_line(qtri_path *path, const qtri_point *from, const qtri_point *to)
{
    int32_t winding = path->direction;
    if (from->y_24p8 > to->y_24p8) {
        const qtri_point *other = from;
        from = to;
        to = other;
        winding = -winding;
    }
    if (from->y_24p8 < to->y_24p8) {
        qtri_ink_edge_set_line(&path->edge[path->count++], from, to, winding);
    }
}

void qtri_path_quarter(qtri_path *path, const qtri_point *center, int32_t radius_24p8,
                       int32_t quarter, int32_t y0_24p8, int32_t y1_24p8)
{
    if (y0_24p8 >= y1_24p8) {
        return; /* all that there is of a circle without a radius */
    }
    const bool is_right = quarter == 0 || quarter == 3;
    qtri_ink_edge *edge = &path->edge[path->count++];
    edge->y0 = y0_24p8;
    edge->y1 = y1_24p8;
    edge->radius = radius_24p8;
    edge->winding = is_right ? path->direction : -path->direction;
    edge->as.arc.center_x = center->x_24p8;
    edge->as.arc.center_y = center->y_24p8;
    edge->as.arc.side = is_right ? 1 : -1;
    edge->x0 = qtri_ink_edge_x(edge, y0_24p8);
    edge->x1 = qtri_ink_edge_x(edge, y1_24p8);
}

void qtri_path_circle(qtri_path *path, const qtri_point *center, int32_t radius_24p8)
{
    for (int32_t quarter = 0; quarter < 4; quarter++) {
        const int32_t up = quarter < 2 ? 0 : radius_24p8;
        qtri_path_quarter(path, center, radius_24p8, quarter, center->y_24p8 - up,
                          center->y_24p8 - up + radius_24p8);
    }
}

void qtri_path_paint(const qtri_path *path, const qtri_surface *surface, const qtri_brush *brush)
{
    const qtri_contour contour = {path->edge, NULL, path->count};
    qtri_paint_contour(surface, &contour, brush);
}
