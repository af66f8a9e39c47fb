/* SPDX-License-Identifier: MIT */
#include "ink.h"
#include "paint_checked.h"

/*
 * Whether its sides share no pixel: with hard edges; with smooth ones where the inner rectangle
 * begins and ends with a row, and does not lie in one column.
 */
static bool is_apart(const qtri_ink *ink, const qtri_area *inner)
{
    return ink == NULL || ink->row == qtri_hard_row ||
           (((inner->y0_24p8 | inner->y1_24p8) & 255) == 0 &&
            (inner->x0_24p8 - 1) >> 8 < inner->x1_24p8 >> 8);
}

/*
 * Above and below with their corners, then what is left at the sides. A pixel that two of them
 * share would be mixed twice: then it is a contour, which is painted in one go.
 */
void qtri_paint_rect_outline(const qtri_surface *surface, const qtri_area *box, int32_t width_24p8,
                             const qtri_brush *brush)
{
    QTRI_CHECK(qtri_check_area(surface, box));
    QTRI_CHECK(qtri_check_width(width_24p8));
    const qtri_area b = qtri_hold_area(box);
    const int32_t width = b.x1_24p8 - b.x0_24p8; /* |.| <= 2^23 */
    const int32_t height = b.y1_24p8 - b.y0_24p8;
    if (width_24p8 <= 0 || width <= 0 || height <= 0) {
        return;
    }
    if (width_24p8 >= width - width_24p8 || width_24p8 >= height - width_24p8) {
        qtri_paint_rect_part(surface, &b, brush);
        return;
    }
    const qtri_area inner = {b.x0_24p8 + width_24p8, b.y0_24p8 + width_24p8, b.x1_24p8 - width_24p8,
                             b.y1_24p8 - width_24p8};
    if (!is_apart(brush->ink, &inner)) {
        qtri_paint_round_rect_outline(surface, &b, 0, width_24p8, brush);
        return;
    }
    const qtri_area side[4] = {{b.x0_24p8, b.y0_24p8, b.x1_24p8, inner.y0_24p8},
                               {b.x0_24p8, inner.y1_24p8, b.x1_24p8, b.y1_24p8},
                               {b.x0_24p8, inner.y0_24p8, inner.x0_24p8, inner.y1_24p8},
                               {inner.x1_24p8, inner.y0_24p8, b.x1_24p8, inner.y1_24p8}};
    for (int i = 0; i < 4; i++) {
        qtri_paint_rect_part(surface, &side[i], brush);
    }
}
