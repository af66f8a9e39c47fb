/* SPDX-License-Identifier: MIT */
#include "ink.h"

/*
 * Above and below with their corners, then what is left at the sides. Mixed pixels must be painted
 * in one go, as a pixel that two smooth edges share would be mixed twice: that is a contour.
 */
void qtri_paint_rect_outline(const qtri_surface *surface, const qtri_area *box, int32_t width_24p8,
                             const qtri_brush *brush)
{
    if (brush->ink != NULL) {
        qtri_paint_round_rect_outline(surface, box, 0, width_24p8, brush);
        return;
    }
    const qtri_area b = qtri_hold_area(box);
    const int32_t width = b.x1_24p8 - b.x0_24p8; /* |.| <= 2^23 */
    const int32_t height = b.y1_24p8 - b.y0_24p8;
    if (width_24p8 <= 0 || width <= 0 || height <= 0) {
        return;
    }
    if (width_24p8 >= width - width_24p8 || width_24p8 >= height - width_24p8) {
        qtri_paint_rect(surface, &b, brush);
        return;
    }
    const qtri_area inner = {b.x0_24p8 + width_24p8, b.y0_24p8 + width_24p8, b.x1_24p8 - width_24p8,
                             b.y1_24p8 - width_24p8};
    const qtri_area side[4] = {{b.x0_24p8, b.y0_24p8, b.x1_24p8, inner.y0_24p8},
                               {b.x0_24p8, inner.y1_24p8, b.x1_24p8, b.y1_24p8},
                               {b.x0_24p8, inner.y0_24p8, inner.x0_24p8, inner.y1_24p8},
                               {inner.x1_24p8, inner.y0_24p8, b.x1_24p8, inner.y1_24p8}};
    for (int i = 0; i < 4; i++) {
        qtri_paint_rect(surface, &side[i], brush);
    }
}
