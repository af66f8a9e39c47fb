/* SPDX-License-Identifier: MIT */
#include "crossing.h"

#include "../bits/multiply.h"
#include "../bits/reciprocal.h"

/*
 * x0 + (x1 - x0) (y - y0) / (y1 - y0) for y0 < y < y1. The quotient t in Q29 is too small by 2^-29
 * at most, and |x1 - x0| <= 2^23: x is off by 2^-6 of a step before it is rounded.
 */
static int32_t line_x(const qtri_ink_edge *edge, int32_t y)
{
    const int32_t dx = edge->x1 - edge->x0;
    if (dx == 0) {
        return edge->x0;
    }
    const uint32_t dy = (uint32_t)(edge->y1 - edge->y0); /* <= 2^23 */
    const int32_t zeros = qtri_clz32(dy);
    // NOLINTNEXTLINE(clang-analyzer-core.UndefinedBinaryOperatorResult): y0 < y1, so dy is not 0
    const uint32_t reciprocal = (uint32_t)qtri_reciprocal_below(dy << zeros);
    const uint32_t t_q29 = qtri_mul_high31((uint32_t)(y - edge->y0) << (zeros - 1), reciprocal);
    return edge->x0 + ((qtri_mul_high_s31(dx * 128, t_q29) + 8) >> 4);
}

int32_t qtri_ink_edge_x(const qtri_ink_edge *edge, int32_t y_24p8)
{
    if (edge->radius == 0) {
        return line_x(edge, y_24p8);
    }
    const uint32_t away = qtri_magnitude32(y_24p8 - edge->center_y); /* <= radius */
    const uint32_t radius = (uint32_t)edge->radius;
    const uint32_t half = (uint32_t)qtri_sqrt64_round(qtri_mul_u32(radius - away, radius + away));
    return edge->center_x + (edge->side < 0 ? -(int32_t)half : (int32_t)half);
}

bool qtri_contour_edge(const qtri_contour *contour, int32_t i, qtri_ink_edge *edge)
{
    if (contour->points == NULL) {
        *edge = contour->edges[i];
        return true;
    }
    const qtri_point *a = &contour->points[i];
    const qtri_point *b = &contour->points[i + 1 < contour->count ? i + 1 : 0];
    const int32_t a_y = qtri_hold_24p8(a->y_24p8);
    const int32_t b_y = qtri_hold_24p8(b->y_24p8);
    edge->winding = a_y < b_y ? 1 : -1;
    edge->radius = 0;
    if (a_y > b_y) {
        const qtri_point *c = a;
        a = b;
        b = c;
    }
    edge->x0 = qtri_hold_24p8(a->x_24p8);
    edge->x1 = qtri_hold_24p8(b->x_24p8);
    edge->y0 = qtri_least32(a_y, b_y);
    edge->y1 = qtri_greatest32(a_y, b_y);
    return a_y != b_y;
}

/* Whether a side of a polygon lies above the row, or below: most do. */
static bool is_beside(const qtri_contour *contour, int32_t i, int32_t top)
{
    const int32_t a = contour->points[i].y_24p8;
    const int32_t b = contour->points[i + 1 < contour->count ? i + 1 : 0].y_24p8;
    const int32_t end = top + 256; /* rows lie between -2^21 and 2^21, where no point is held */
    return (a <= top && b <= top) || (a >= end && b >= end);
}

/* Edge i where it may cross the row, `room` being for a side of a polygon. NULL: it does not. */
static const qtri_ink_edge *edge_of(const qtri_contour *contour, int32_t i, int32_t top,
                                    qtri_ink_edge *room)
{
    if (contour->points == NULL) {
        const qtri_ink_edge *edge = &contour->edges[i];
        return edge->y0 < top + 256 && edge->y1 > top ? edge : NULL;
    }
    return !is_beside(contour, i, top) && qtri_contour_edge(contour, i, room) ? room : NULL;
}

static bool cross(const qtri_crossings *crossings, int32_t i, qtri_crossing *crossing)
{
    const qtri_contour *contour = crossings->contour;
    const int32_t top = crossings->row_24p8;
    qtri_ink_edge room;
    const qtri_ink_edge *edge = edge_of(contour, i, top, &room);
    if (edge == NULL) {
        return false;
    }
    crossing->winding = edge->winding;
    crossing->arc = edge->radius != 0 ? &contour->edges[i] : NULL;
    if (crossings->at_center) {
        if (edge->y0 > top + 128 || edge->y1 <= top + 128) {
            return false;
        }
        crossing->x0 = crossing->x1 = qtri_ink_edge_x(edge, top + 128);
        return true;
    }
    /* The edge has y0 < y1, begins above the row's end and ends below its top: so does the rest. */
    const int32_t y0 = qtri_greatest32(edge->y0, top);
    const int32_t y1 = qtri_least32(edge->y1, top + 256);
    crossing->y0 = y0 - top;
    crossing->y1 = y1 - top;
    crossing->x0 = y0 == edge->y0 ? edge->x0 : qtri_ink_edge_x(edge, y0);
    crossing->x1 = y1 == edge->y1 ? edge->x1 : qtri_ink_edge_x(edge, y1);
    return true;
}

void qtri_crossings_init(qtri_crossings *crossings, const qtri_contour *contour, int32_t row,
                         bool at_center)
{
    crossings->contour = contour;
    crossings->row_24p8 = row * 256;
    crossings->at_center = at_center;
    crossings->kept = 0;
    int32_t i = 0;
    for (; i < contour->count && crossings->kept < QTRI_CROSSINGS_KEPT; i++) {
        crossings->kept += cross(crossings, i, &crossings->crossing[crossings->kept]);
    }
    crossings->others = i;
}

const qtri_crossing *qtri_crossings_next(const qtri_crossings *crossings, int32_t *position,
                                         qtri_crossing *room)
{
    if (*position < crossings->kept) {
        return &crossings->crossing[(*position)++];
    }
    int32_t i = crossings->others + (*position - crossings->kept);
    for (; i < crossings->contour->count; i++) {
        (*position)++;
        if (cross(crossings, i, room)) {
            return room;
        }
    }
    return NULL;
}
