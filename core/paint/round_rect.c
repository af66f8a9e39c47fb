/* SPDX-License-Identifier: MIT */
#include "paint_checked.h"
#include "path.h"

/* Right and left side, and a quarter of a circle at each corner. */
static void add(qtri_path *path, const qtri_area *b, int32_t radius)
{
    const int32_t right = b->x1_24p8 - radius;
    const int32_t left = b->x0_24p8 + radius;
    const int32_t low = b->y1_24p8 - radius;
    const int32_t high = b->y0_24p8 + radius;
    const qtri_point side[4] = {
        {b->x1_24p8, high}, {b->x1_24p8, low}, {b->x0_24p8, low}, {b->x0_24p8, high}};
    const qtri_point corner[4] = {{right, low}, {left, low}, {left, high}, {right, high}};
    qtri_path_line(path, &side[0], &side[1]);
    qtri_path_line(path, &side[2], &side[3]);
    for (int32_t quarter = 0; quarter < 4; quarter++) {
        const int32_t y = corner[quarter].y_24p8 - (quarter < 2 ? 0 : radius);
        qtri_path_quarter(path, &corner[quarter], radius, quarter, y, y + radius);
    }
}

/* The box, and the radius that fits into it; false: it has no inside. */
static bool begin(const qtri_area *box, int32_t *radius, qtri_area *held)
{
    *held = qtri_hold_area(box);
    const int32_t width = held->x1_24p8 - held->x0_24p8; /* |.| <= 2^23 */
    const int32_t height = held->y1_24p8 - held->y0_24p8;
    if (width <= 0 || height <= 0) {
        return false;
    }
    int32_t most = (width < height ? width : height) / 2;
    most = most < QTRI_PAINT_RADIUS_MAX_24P8 ? most : QTRI_PAINT_RADIUS_MAX_24P8;
    *radius = *radius < 0 ? 0 : (*radius > most ? most : *radius);
    return true;
}

void qtri_paint_round_rect(const qtri_surface *surface, const qtri_area *box, int32_t radius_24p8,
                           const qtri_brush *brush)
{
    QTRI_CHECK(qtri_check_area(surface, box));
    qtri_area held;
    qtri_path path;
    qtri_path_init(&path);
    if (begin(box, &radius_24p8, &held)) {
        add(&path, &held, radius_24p8);
        qtri_path_paint(&path, surface, brush);
    }
}

void qtri_paint_round_rect_outline(const qtri_surface *surface, const qtri_area *box,
                                   int32_t radius_24p8, int32_t width_24p8, const qtri_brush *brush)
{
    QTRI_CHECK(qtri_check_area(surface, box));
    QTRI_CHECK(qtri_check_width(width_24p8));
    qtri_area b;
    qtri_path path;
    qtri_path_init(&path);
    if (width_24p8 <= 0 || !begin(box, &radius_24p8, &b)) {
        return;
    }
    add(&path, &b, radius_24p8);
    const int32_t w = width_24p8 < 2 * QTRI_PAINT_MAX_24P8 ? width_24p8 : 2 * QTRI_PAINT_MAX_24P8;
    const qtri_area inner = {b.x0_24p8 + w, b.y0_24p8 + w, b.x1_24p8 - w, b.y1_24p8 - w};
    if (inner.x0_24p8 < inner.x1_24p8 && inner.y0_24p8 < inner.y1_24p8) {
        path.direction = -1;
        add(&path, &inner, radius_24p8 > w ? radius_24p8 - w : 0);
    }
    qtri_path_paint(&path, surface, brush);
}
