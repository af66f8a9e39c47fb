/* SPDX-License-Identifier: MIT */
#include "ink.h"
#include "paint_checked.h"

#ifdef QTRI_CHECKED
void qtri_paint_rect(const qtri_surface *surface, const qtri_area *box, const qtri_brush *brush)
{
    qtri_check_area(surface, box);
    qtri_paint_rect_part(surface, box, brush);
}
#endif

void qtri_paint_rect_part(const qtri_surface *surface, const qtri_area *box,
                          const qtri_brush *brush)
{
    const qtri_area held = qtri_hold_area(box);
    qtri_painter painter;
    if (held.x0_24p8 >= held.x1_24p8 || held.y0_24p8 >= held.y1_24p8 ||
        !qtri_painter_begin(&painter, surface, brush)) {
        return;
    }
    if (brush->ink == NULL) {
        qtri_hard_rect(&painter, &held);
    } else {
        brush->ink->rect(&painter, &held);
    }
}
