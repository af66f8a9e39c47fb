/* SPDX-License-Identifier: MIT */
#include "ink.h"
#include "paint_checked.h"

#include "../bits/bits.h"

/* side width / 2 length, to nearest; |side| <= 2^23, width < 2^23. */
static int32_t offset_of(int32_t side, int32_t width, uint64_t length)
{
    bool half;
    const uint64_t n = qtri_mul_u32(qtri_magnitude32(side), (uint32_t)width);
    const int32_t offset = (int32_t)(qtri_divide64(n, 2 * length, 0, &half) + half);
    return side < 0 ? -offset : offset;
}

#ifdef QTRI_CHECKED
static void check_stroke(const qtri_surface *surface, qtri_point from, qtri_point to, int32_t width)
{
    const qtri_point end[2] = {from, to};
    qtri_check_points(surface, end, 2);
    qtri_check_width(width);
}
#endif

void qtri_paint_stroke(const qtri_surface *surface, const qtri_point *from, const qtri_point *to,
                       int32_t width_24p8, const qtri_brush *brush)
{
    QTRI_ASSERT(from != NULL);
    QTRI_ASSERT(to != NULL);
    QTRI_CHECK(check_stroke(surface, *from, *to, width_24p8));
    const qtri_point a = {qtri_hold_24p8(from->x_24p8), qtri_hold_24p8(from->y_24p8)};
    const qtri_point b = {qtri_hold_24p8(to->x_24p8), qtri_hold_24p8(to->y_24p8)};
    const int32_t dx = b.x_24p8 - a.x_24p8; /* |.| <= 2^23 */
    const int32_t dy = b.y_24p8 - a.y_24p8;
    if (width_24p8 <= 0 || (dx | dy) == 0) {
        return;
    }
    const int32_t width = qtri_hold_24p8(width_24p8);
    const uint64_t square = (uint64_t)qtri_mul_s32(dx, dx) + (uint64_t)qtri_mul_s32(dy, dy);
    const uint64_t length = qtri_sqrt64_round(square); /* >= 1 */
    const int32_t x = offset_of(-dy, width, length);
    const int32_t y = offset_of(dx, width, length);
    const qtri_point point[4] = {{a.x_24p8 + x, a.y_24p8 + y},
                                 {b.x_24p8 + x, b.y_24p8 + y},
                                 {b.x_24p8 - x, b.y_24p8 - y},
                                 {a.x_24p8 - x, a.y_24p8 - y}};
    qtri_paint_polygon_part(surface, point, 4, brush);
}
