/* SPDX-License-Identifier: MIT */
#include "contour.h"

#include "../bits/bits.h"

/* ---- Edges ---- */

/*
 * x0 + (x1 - x0) (y - y0) / (y1 - y0) for y0 < y < y1. The quotient t in Q29 is too small by 2^-29
 * at most, and |x1 - x0| <= 2^23: x is off by 2^-6 of a step before it is rounded.
 */
static int32_t line_x(const qtri_ink_edge *edge, int32_t y)
{
    const qtri_ink_line *line = &edge->as.line;
    if (line->reciprocal == 0) {
        return edge->x0;
    }
    const int32_t dx = edge->x1 - edge->x0;
    const uint32_t t_q29 =
        qtri_mul_high31((uint32_t)(y - edge->y0) << (line->zeros - 1), line->reciprocal);
    return edge->x0 + ((qtri_mul_high_s31(dx * 128, t_q29) + 8) >> 4);
}

/* Makes a straight edge of its ends, y0 < y1. */
static void set_line(qtri_ink_edge *edge, const qtri_point *from, const qtri_point *to,
                     int32_t winding)
{
    edge->x0 = from->x_24p8;
    edge->y0 = from->y_24p8;
    edge->x1 = to->x_24p8;
    edge->y1 = to->y_24p8;
    edge->radius = 0;
    edge->winding = winding;
    edge->as.line.reciprocal = 0;
    if (edge->x0 != edge->x1) {
        const uint32_t dy = (uint32_t)(edge->y1 - edge->y0); /* <= 2^23 */
        const int32_t zeros = qtri_clz32(dy);
        // NOLINTNEXTLINE(clang-analyzer-core.UndefinedBinaryOperatorResult): y0 < y1, so not 0
        edge->as.line.reciprocal = (uint32_t)qtri_reciprocal_below(dy << zeros);
        edge->as.line.zeros = zeros;
    }
}

/* Of most circles the square fits 32 bits, and so does each product of two parts of it. */
int32_t qtri_ink_half_chord(const qtri_ink_edge *arc, int32_t y_24p8)
{
    const uint32_t away = qtri_magnitude32(y_24p8 - arc->as.arc.center_y); /* <= radius */
    const uint32_t radius = (uint32_t)arc->radius;
    if (away == 0) {
        return arc->radius;
    }
    if (radius < (uint32_t)1 << 16) {
        return (int32_t)qtri_sqrt32_round((radius - away) * (radius + away));
    }
    return (int32_t)qtri_sqrt64_round(qtri_mul_u32(radius - away, radius + away));
}

/* x of an edge at y0 <= y <= y1, rounded to 1/256. */
static int32_t edge_x(const qtri_ink_edge *edge, int32_t y_24p8)
{
    if (edge->radius == 0) {
        return line_x(edge, y_24p8);
    }
    const int32_t half = qtri_ink_half_chord(edge, y_24p8);
    return edge->as.arc.center_x + (edge->as.arc.side < 0 ? -half : half);
}

/* Edge i of a contour; false: a side of the polygon is horizontal. */
static bool contour_edge(const qtri_contour *contour, int32_t i, qtri_ink_edge *edge)
{
    if (contour->points == NULL) {
        *edge = contour->edges[i];
        return true;
    }
    const qtri_point *a = &contour->points[i];
    const qtri_point *b = &contour->points[i + 1 < contour->count ? i + 1 : 0];
    const qtri_point from = qtri_hold_point(a);
    const qtri_point to = qtri_hold_point(b);
    if (from.y_24p8 == to.y_24p8) {
        return false;
    }
    if (from.y_24p8 < to.y_24p8) {
        set_line(edge, &from, &to, 1);
    } else {
        set_line(edge, &to, &from, -1);
    }
    return true;
}

/* ---- Rows without smooth edges ---- */

/*
 * The columns of a row at which the winding number changes, in order; edges that meet in a column
 * are one stop. If there are more than STOPS, these are the first.
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

/* Most sides lie above, or below; rows lie between -2^21 and 2^21, where no point is held. */
QTRI_NOINLINE static const qtri_ink_edge *side_of(const qtri_contour *contour, int32_t i,
                                                  int32_t top, int32_t end, qtri_ink_edge *room)
{
    const int32_t a = contour->points[i].y_24p8;
    const int32_t b = contour->points[i + 1 < contour->count ? i + 1 : 0].y_24p8;
    const bool is_beside = (a <= top && b <= top) || (a >= end && b >= end);
    return !is_beside && contour_edge(contour, i, room) ? room : NULL;
}

/*
 * Edge i where it reaches between the heights `top` and `end`, `room` being for a side of a
 * polygon. NULL: it does not.
 */
static inline const qtri_ink_edge *edge_of(const qtri_contour *contour, int32_t i, int32_t top,
                                           int32_t end, qtri_ink_edge *room)
{
    if (contour->points != NULL) {
        return side_of(contour, i, top, end, room);
    }
    const qtri_ink_edge *edge = &contour->edges[i];
    return edge->y0 < end && edge->y1 > top ? edge : NULL;
}

/* Finds the stops behind column `from`. Two arcs in succession are often of one circle. */
static void find_stops(stops *s, const qtri_contour *contour, int32_t row, int32_t from)
{
    const int32_t y = row * 256 + 128;
    const qtri_ink_edge *last = NULL; /* arc, */
    int32_t half = 0;                 /* and half of its chord */
    s->count = 0;
    for (int32_t i = 0; i < contour->count; i++) {
        qtri_ink_edge room;
        const qtri_ink_edge *edge = edge_of(contour, i, y, y + 1, &room);
        if (edge == NULL) {
            continue;
        }
        int32_t x;
        if (edge->radius == 0) {
            x = edge_x(edge, y);
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

/* Paints the pixels whose winding number is not 0. */
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

/* The rows *first..*end - 1 that the contour touches, within bounds. */
static void rows_of(const qtri_contour *contour, const qtri_rect *bounds, int32_t *first,
                    int32_t *end)
{
    int32_t y0 = INT32_MAX;
    int32_t y1 = INT32_MIN;
    for (int32_t i = 0; i < contour->count; i++) {
        qtri_ink_edge edge;
        if (contour_edge(contour, i, &edge)) {
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
    int32_t row, end;
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

const qtri_ink qtri_ink_blend = {qtri_blend_span, qtri_blend_cover, qtri_blend_bits, qtri_hard_row,
                                 qtri_hard_rect};

/* ---- Edges that cross a row ---- */

/* x of another arc at the level where `arc` is at x. */
static int32_t mirrored(const qtri_ink_edge *arc, const qtri_ink_edge *other, int32_t x)
{
    const int32_t half = (x - arc->as.arc.center_x) * arc->as.arc.side;
    return other->as.arc.center_x + half * other->as.arc.side;
}

static bool cut_to_row(const qtri_crossings *crossings, int32_t i, qtri_crossing *crossing)
{
    const qtri_contour *contour = crossings->contour;
    const int32_t top = crossings->row_24p8;
    qtri_ink_edge room;
    const qtri_ink_edge *edge = edge_of(contour, i, top, top + 256, &room);
    if (edge == NULL) {
        return false;
    }
    crossing->winding = edge->winding;
    crossing->arc = edge->radius != 0 ? &contour->edges[i] : NULL;
    /* The edge has y0 < y1, begins above the row's end and ends below its top: so does the rest. */
    const int32_t y0 = qtri_greatest32(edge->y0, top);
    const int32_t y1 = qtri_least32(edge->y1, top + 256);
    crossing->y0 = y0 - top;
    crossing->y1 = y1 - top;
    if (crossings->kept > 0) {
        const qtri_crossing *last = &crossings->crossing[crossings->kept - 1];
        if (last->y0 == crossing->y0 && last->y1 == crossing->y1 &&
            qtri_ink_is_mirrored(last->arc, edge)) {
            crossing->x0 = mirrored(last->arc, edge, last->x0);
            crossing->x1 = mirrored(last->arc, edge, last->x1);
            return true;
        }
    }
    crossing->x0 = y0 == edge->y0 ? edge->x0 : edge_x(edge, y0);
    crossing->x1 = y1 == edge->y1 ? edge->x1 : edge_x(edge, y1);
    return true;
}

void qtri_crossings_init(qtri_crossings *crossings, const qtri_contour *contour, int32_t row)
{
    crossings->contour = contour;
    crossings->row_24p8 = row * 256;
    crossings->kept = 0;
    int32_t least = INT32_MAX;
    int32_t i = 0;
    for (; i < contour->count && crossings->kept < QTRI_CROSSINGS_KEPT; i++) {
        qtri_crossing *c = &crossings->crossing[crossings->kept];
        if (cut_to_row(crossings, i, c)) {
            least = qtri_least32(least, qtri_least32(c->x0, c->x1));
            crossings->kept++;
        }
    }
    crossings->others = i;
    crossings->first = i == contour->count ? least >> 8 : INT32_MIN;
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
        if (cut_to_row(crossings, i, room)) {
            return room;
        }
    }
    return NULL;
}

/* ---- Contours of lines and arcs ---- */

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
        set_line(&path->edge[path->count++], from, to, winding);
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
    edge->x0 = edge_x(edge, y0_24p8);
    edge->x1 = edge_x(edge, y1_24p8);
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
