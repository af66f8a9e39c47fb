/* SPDX-License-Identifier: MIT */
#include "crossing.h"

#include "../bits/bits.h"

/*
 * Columns of a row from which on the contour has turned around differently, in their order. Edges
 * that meet in a column are one. Of more than there is room for these are the first.
 */
enum { STOPS = 12 };

typedef struct stop {
    int32_t x, winding;
} stop;

typedef struct stops {
    int32_t count;
    stop of[STOPS];
} stops;

static void add_stop(stops *s, int32_t x, int32_t winding)
{
    int32_t i = s->count;
    while (i > 0 && s->of[i - 1].x > x) {
        i--;
    }
    if (i > 0 && s->of[i - 1].x == x) {
        s->of[i - 1].winding += winding;
        return;
    }
    if (i == STOPS) {
        return;
    }
    const int32_t kept = qtri_least32(s->count, STOPS - 1);
    for (int32_t k = kept; k > i; k--) {
        s->of[k] = s->of[k - 1];
    }
    s->of[i].x = x;
    s->of[i].winding = winding;
    s->count = kept + 1;
}

/* Those behind the column `from`. Two arcs that follow each other are often of one circle. */
static void find_stops(stops *s, const qtri_contour *contour, int32_t row, int32_t from)
{
    const int32_t y = row * 256 + 128;
    const qtri_ink_edge *last = NULL; /* arc, */
    int32_t half = 0;                 /* and half of its chord */
    s->count = 0;
    for (int32_t i = 0; i < contour->count; i++) {
        qtri_ink_edge side;
        const qtri_ink_edge *edge = &side;
        if (contour->points == NULL) {
            edge = &contour->edges[i];
        } else if (!qtri_contour_side_near(contour, i, row * 256, &side)) {
            continue;
        }
        if (edge->y0 > y || edge->y1 <= y) {
            continue;
        }
        int32_t x;
        if (edge->radius == 0) {
            x = qtri_ink_edge_x(edge, y);
        } else {
            if (!qtri_ink_is_mirrored(last, edge)) {
                last = edge;
                half = qtri_ink_half_chord(edge, y);
            }
            x = edge->as.arc.center_x + (edge->as.arc.side < 0 ? -half : half);
        }
        x = qtri_pixel_from(x);
        if (x > from) {
            add_stop(s, x, edge->winding);
        }
    }
}

/* Where the contour has turned around in sum, inside. */
void qtri_hard_row(const qtri_painter *painter, const qtri_contour *contour, int32_t row)
{
    stops s;
    int32_t from = INT32_MIN;
    int32_t winding = 0;
    do {
        find_stops(&s, contour, row, from);
        for (int32_t i = 0; i < s.count; i++) {
            if (winding != 0) {
                qtri_painter_span(painter, row, from, s.of[i].x, 255);
            }
            winding += s.of[i].winding;
            from = s.of[i].x;
        }
    } while (s.count == STOPS);
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
