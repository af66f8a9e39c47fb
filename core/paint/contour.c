/* SPDX-License-Identifier: MIT */
#include "crossing.h"

/*
 * From one crossing to the next on the right: where the contour has turned around in sum, inside.
 * At most as many steps as crossings, so no order of them is kept.
 */
void qtri_hard_row(const qtri_painter *painter, const qtri_contour *contour, int32_t row)
{
    qtri_crossings crossings;
    qtri_crossings_init(&crossings, contour, row, true);
    int32_t from = INT32_MIN;
    int32_t winding = 0;
    for (;;) {
        int32_t to = INT32_MAX;
        int32_t change = 0;
        int32_t position = 0;
        qtri_crossing room;
        const qtri_crossing *c;
        while ((c = qtri_crossings_next(&crossings, &position, &room)) != NULL) {
            const int32_t x = qtri_pixel_from(c->x0);
            if (x > from && x <= to) {
                change = x < to ? c->winding : change + c->winding;
                to = x;
            }
        }
        if (to == INT32_MAX) {
            return;
        }
        if (winding != 0) {
            qtri_painter_span(painter, row, from, to, 255);
        }
        winding += change;
        from = to;
    }
}

/* Rows that the contour touches, as far as they are to be painted. */
static void rows_of(const qtri_contour *contour, const qtri_rect *bounds, int32_t *first,
                    int32_t *end)
{
    int32_t y0 = INT32_MAX;
    int32_t y1 = INT32_MIN;
    for (int32_t i = 0; i < contour->count; i++) {
        qtri_ink_edge edge;
        if (qtri_contour_edge(contour, i, &edge)) {
            y0 = edge.y0 < y0 ? edge.y0 : y0;
            y1 = edge.y1 > y1 ? edge.y1 : y1;
        }
    }
    *first = y0 >> 8 > bounds->y0 ? y0 >> 8 : bounds->y0;
    *end = y1 < bounds->y1 * 256 ? (y1 + 255) >> 8 : bounds->y1;
}

void qtri_paint_contour(const qtri_surface *surface, const qtri_contour *contour,
                        const qtri_brush *brush)
{
    qtri_painter painter;
    int32_t row;
    int32_t end;
    if (!qtri_painter_begin(&painter, surface, brush)) {
        return;
    }
    rows_of(contour, &painter.bounds, &row, &end);
    for (; row < end; row++) {
        if (painter.ink == NULL) {
            qtri_hard_row(&painter, contour, row);
        } else {
            painter.ink->row(&painter, contour, row);
        }
    }
}
