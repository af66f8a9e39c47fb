/* SPDX-License-Identifier: MIT */
/* Draw calls of rectangles, circles, arcs, polygons and lines. */
#include "contour.h"

#include "qtri/q16.h"

#include "../bits/bits.h"

/* ---- Checked builds: integer pixels, QTRI_PX() forgotten ---- */

#ifdef QTRI_CHECKED

/* Below 1/16 pixel a width is hardly seen. */
enum { PLAIN_WIDTH_MAX_24P8 = 15 };

/*
 * Whether a shape seems to have integer pixels for 24.8: it is thinner than a pixel, and lies in
 * the frame's first corner, as far from it in 1/256 pixel as the frame has pixels. A shape that is
 * meant so has its ends on whole or half pixels, or is cut off by the frame's side.
 */
static bool is_plain_area(const qtri_surface *surface, const qtri_area *box, int32_t finest)
{
    const int64_t width = (int64_t)box->x1_24p8 - box->x0_24p8;
    const int64_t height = (int64_t)box->y1_24p8 - box->y0_24p8;
    const bool is_thin = width < 256 || height < 256;
    const bool is_first = box->x0_24p8 >= 0 && box->x1_24p8 <= surface->width &&
                          box->y0_24p8 >= 0 && box->y1_24p8 <= surface->height;
    return is_thin && is_first && (finest & 127) != 0;
}

/* An area without an inside is none. */
static void check_area(const qtri_surface *surface, const qtri_area *box)
{
    QTRI_ASSERT(surface != NULL);
    QTRI_ASSERT(box != NULL);
    const bool is_empty = box->x0_24p8 >= box->x1_24p8 || box->y0_24p8 >= box->y1_24p8;
    const int32_t finest = box->x0_24p8 | box->y0_24p8 | box->x1_24p8 | box->y1_24p8;
    QTRI_ASSERT(is_empty || !is_plain_area(surface, box, finest));
}

static void check_circle(const qtri_surface *surface, const qtri_point *center, int32_t radius)
{
    QTRI_ASSERT(surface != NULL);
    QTRI_ASSERT(center != NULL);
    const qtri_point c = qtri_hold_point(center);
    const int32_t r = qtri_hold_24p8(radius);
    const qtri_area box = {c.x_24p8 - r, c.y_24p8 - r, c.x_24p8 + r, c.y_24p8 + r};
    QTRI_ASSERT(r <= 0 || !is_plain_area(surface, &box, c.x_24p8 | c.y_24p8 | r));
}

static void check_points(const qtri_surface *surface, const qtri_point *point, int32_t count)
{
    QTRI_ASSERT(surface != NULL);
    QTRI_ASSERT(point != NULL || count <= 0);
    qtri_area box = {INT32_MAX, INT32_MAX, INT32_MIN, INT32_MIN};
    int32_t finest = 0;
    for (int32_t i = 0; i < count; i++) {
        const qtri_point p = point[i];
        box.x0_24p8 = p.x_24p8 < box.x0_24p8 ? p.x_24p8 : box.x0_24p8;
        box.y0_24p8 = p.y_24p8 < box.y0_24p8 ? p.y_24p8 : box.y0_24p8;
        box.x1_24p8 = p.x_24p8 > box.x1_24p8 ? p.x_24p8 : box.x1_24p8;
        box.y1_24p8 = p.y_24p8 > box.y1_24p8 ? p.y_24p8 : box.y1_24p8;
        finest |= p.x_24p8 | p.y_24p8;
    }
    const bool is_point = box.x0_24p8 == box.x1_24p8 && box.y0_24p8 == box.y1_24p8;
    QTRI_ASSERT(count <= 0 || is_point || !is_plain_area(surface, &box, finest));
}

/* A width of 0 or less paints nothing. */
static void check_width(int32_t width_24p8)
{
    QTRI_ASSERT(width_24p8 <= 0 || width_24p8 > PLAIN_WIDTH_MAX_24P8);
}

/* A ring as wide as its radius is a circle, or a sector. */
static void check_ring_width(int32_t radius_24p8, int32_t width_24p8)
{
    check_width(width_24p8 < radius_24p8 ? width_24p8 : 0);
}

static void check_stroke(const qtri_surface *surface, qtri_point from, qtri_point to, int32_t width)
{
    const qtri_point end[2] = {from, to};
    check_points(surface, end, 2);
    check_width(width);
}

#endif

/* ---- Rectangles ---- */

static qtri_area hold_area(const qtri_area *box)
{
    qtri_area held = {qtri_hold_24p8(box->x0_24p8), qtri_hold_24p8(box->y0_24p8),
                      qtri_hold_24p8(box->x1_24p8), qtri_hold_24p8(box->y1_24p8)};
    return held;
}

static void paint_rect(const qtri_surface *surface, const qtri_area *box, const qtri_brush *brush)
{
    const qtri_area held = hold_area(box);
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

void qtri_paint_rect(const qtri_surface *surface, const qtri_area *box, const qtri_brush *brush)
{
    QTRI_CHECK(check_area(surface, box));
    paint_rect(surface, box, brush);
}

/*
 * Whether the sides of a rectangle's outline share no pixel: with hard edges; with smooth ones
 * where the inner rectangle begins and ends with a row, and does not lie in one column.
 */
static bool are_sides_apart(const qtri_ink *ink, const qtri_area *inner)
{
    return ink == NULL || ink->row == qtri_hard_row ||
           (((inner->y0_24p8 | inner->y1_24p8) & 255) == 0 &&
            (inner->x0_24p8 - 1) >> 8 < inner->x1_24p8 >> 8);
}

/*
 * Paints upper and lower side with the corners, then left and right side. A pixel that two of them
 * share would be blended twice: then the outline is painted as one contour.
 */
void qtri_paint_rect_outline(const qtri_surface *surface, const qtri_area *box, int32_t width_24p8,
                             const qtri_brush *brush)
{
    QTRI_CHECK(check_area(surface, box));
    QTRI_CHECK(check_width(width_24p8));
    const qtri_area b = hold_area(box);
    const int32_t width = b.x1_24p8 - b.x0_24p8; /* |.| <= 2^23 */
    const int32_t height = b.y1_24p8 - b.y0_24p8;
    if (width_24p8 <= 0 || width <= 0 || height <= 0) {
        return;
    }
    if (width_24p8 >= width - width_24p8 || width_24p8 >= height - width_24p8) {
        paint_rect(surface, &b, brush);
        return;
    }
    const qtri_area inner = {b.x0_24p8 + width_24p8, b.y0_24p8 + width_24p8, b.x1_24p8 - width_24p8,
                             b.y1_24p8 - width_24p8};
    if (!are_sides_apart(brush->ink, &inner)) {
        qtri_paint_round_rect_outline(surface, &b, 0, width_24p8, brush);
        return;
    }
    const qtri_area side[4] = {{b.x0_24p8, b.y0_24p8, b.x1_24p8, inner.y0_24p8},
                               {b.x0_24p8, inner.y1_24p8, b.x1_24p8, b.y1_24p8},
                               {b.x0_24p8, inner.y0_24p8, inner.x0_24p8, inner.y1_24p8},
                               {inner.x1_24p8, inner.y0_24p8, b.x1_24p8, inner.y1_24p8}};
    for (int i = 0; i < 4; i++) {
        paint_rect(surface, &side[i], brush);
    }
}

/* Adds right and left side, and a quarter of a circle at each corner. */
static void add_round_rect(qtri_path *path, const qtri_area *b, int32_t radius)
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

/* Clamps the box, and the radius to what fits into it; false: the box has no inside. */
static bool clamp_round_rect(const qtri_area *box, int32_t *radius, qtri_area *held)
{
    *held = hold_area(box);
    const int32_t width = held->x1_24p8 - held->x0_24p8; /* |.| <= 2^23 */
    const int32_t height = held->y1_24p8 - held->y0_24p8;
    if (width <= 0 || height <= 0) {
        return false;
    }
    const int32_t most = qtri_least32(qtri_least32(width, height) / 2, QTRI_PAINT_RADIUS_MAX_24P8);
    *radius = qtri_hold32(*radius, 0, most);
    return true;
}

void qtri_paint_round_rect(const qtri_surface *surface, const qtri_area *box, int32_t radius_24p8,
                           const qtri_brush *brush)
{
    QTRI_CHECK(check_area(surface, box));
    qtri_area held;
    qtri_path path;
    qtri_path_init(&path);
    if (clamp_round_rect(box, &radius_24p8, &held)) {
        add_round_rect(&path, &held, radius_24p8);
        qtri_path_paint(&path, surface, brush);
    }
}

void qtri_paint_round_rect_outline(const qtri_surface *surface, const qtri_area *box,
                                   int32_t radius_24p8, int32_t width_24p8, const qtri_brush *brush)
{
    QTRI_CHECK(check_area(surface, box));
    QTRI_CHECK(check_width(width_24p8));
    qtri_area b;
    qtri_path path;
    qtri_path_init(&path);
    if (width_24p8 <= 0 || !clamp_round_rect(box, &radius_24p8, &b)) {
        return;
    }
    add_round_rect(&path, &b, radius_24p8);
    const int32_t w = qtri_least32(width_24p8, 2 * QTRI_PAINT_MAX_24P8);
    const qtri_area inner = {b.x0_24p8 + w, b.y0_24p8 + w, b.x1_24p8 - w, b.y1_24p8 - w};
    if (inner.x0_24p8 < inner.x1_24p8 && inner.y0_24p8 < inner.y1_24p8) {
        path.direction = -1;
        add_round_rect(&path, &inner, radius_24p8 > w ? radius_24p8 - w : 0);
    }
    qtri_path_paint(&path, surface, brush);
}

/* ---- Circles ---- */

static void paint_ring(const qtri_surface *surface, const qtri_point *center, int32_t radius_24p8,
                       int32_t width_24p8, const qtri_brush *brush)
{
    if (radius_24p8 <= 0 || width_24p8 <= 0) {
        return;
    }
    const qtri_point held = qtri_hold_point(center);
    const int32_t radius = qtri_least32(radius_24p8, QTRI_PAINT_RADIUS_MAX_24P8);
    qtri_path path;
    qtri_path_init(&path);
    qtri_path_circle(&path, &held, radius);
    if (width_24p8 < radius) {
        path.direction = -1;
        qtri_path_circle(&path, &held, radius - width_24p8);
    }
    qtri_path_paint(&path, surface, brush);
}

void qtri_paint_ring(const qtri_surface *surface, const qtri_point *center, int32_t radius_24p8,
                     int32_t width_24p8, const qtri_brush *brush)
{
    QTRI_CHECK(check_circle(surface, center, radius_24p8));
    QTRI_CHECK(check_ring_width(radius_24p8, width_24p8));
    paint_ring(surface, center, radius_24p8, width_24p8, brush);
}

void qtri_paint_circle(const qtri_surface *surface, const qtri_point *center, int32_t radius_24p8,
                       const qtri_brush *brush)
{
    QTRI_CHECK(check_circle(surface, center, radius_24p8));
    paint_ring(surface, center, radius_24p8, radius_24p8, brush);
}

#define DEGREES(n) ((int32_t)(n)*65536)

/* radius times a sine, to nearest: below 2^21 2^16, in 64 bits. */
static int32_t scaled(int32_t radius, q16 sine)
{
    return (int32_t)((qtri_mul_s32(radius, sine) + 0x8000) >> 16);
}

static qtri_point point_at(const qtri_point *center, int32_t radius, q16 angle)
{
    q16 sine;
    q16 cosine;
    q16_sincos_deg(angle, &sine, &cosine);
    const qtri_point point = {center->x_24p8 + scaled(radius, cosine),
                              center->y_24p8 + scaled(radius, sine)};
    return point;
}

/* Adds an arc clockwise between two angles, 0 <= from < 360, from < to < from + 360 degrees. */
static void add_arc(qtri_path *path, const qtri_point *center, int32_t radius, q16 from, q16 to)
{
    for (int32_t i = from / DEGREES(90); DEGREES(90) * i < to; i++) {
        const q16 first = qtri_greatest32(from, DEGREES(90) * i);
        const q16 last = qtri_least32(to, DEGREES(90) * (i + 1));
        const int32_t a = point_at(center, radius, first).y_24p8;
        const int32_t b = point_at(center, radius, last).y_24p8;
        qtri_path_quarter(path, center, radius, i & 3, qtri_least32(a, b), qtri_greatest32(a, b));
    }
}

static void add_radial_line(qtri_path *path, const qtri_point *center, int32_t inner, int32_t outer,
                            q16 angle)
{
    const qtri_point from = point_at(center, inner, angle);
    const qtri_point to = point_at(center, outer, angle);
    qtri_path_line(path, &from, &to);
}

void qtri_paint_arc(const qtri_surface *surface, const qtri_point *center, int32_t radius_24p8,
                    int32_t width_24p8, q16 from, q16 sweep, const qtri_brush *brush)
{
    QTRI_CHECK(check_circle(surface, center, radius_24p8));
    QTRI_CHECK(check_ring_width(radius_24p8, width_24p8));
    if (sweep >= DEGREES(360) || sweep <= -DEGREES(360)) {
        paint_ring(surface, center, radius_24p8, width_24p8, brush);
        return;
    }
    if (radius_24p8 <= 0 || width_24p8 <= 0 || sweep == 0) {
        return;
    }
    const qtri_point held = qtri_hold_point(center);
    const int32_t outer = qtri_least32(radius_24p8, QTRI_PAINT_RADIUS_MAX_24P8);
    const int32_t inner = width_24p8 < outer ? outer - width_24p8 : 0;
    from = q16_mod(from, DEGREES(360));
    q16 to = from + sweep; /* |.| < 720 */
    if (sweep < 0) {
        const q16 turn = to < 0 ? DEGREES(360) : 0;
        to = from + turn;
        from = to + sweep;
    }
    qtri_path path;
    qtri_path_init(&path);
    add_arc(&path, &held, outer, from, to);
    add_radial_line(&path, &held, inner, outer, from);
    path.direction = -1;
    add_radial_line(&path, &held, inner, outer, to);
    if (inner > 0) {
        add_arc(&path, &held, inner, from, to);
    }
    qtri_path_paint(&path, surface, brush);
}

/* ---- Polygons and lines ---- */

static void paint_polygon(const qtri_surface *surface, const qtri_point *point, int32_t count,
                          const qtri_brush *brush)
{
    if (count > QTRI_PATH_EDGES) {
        const qtri_contour contour = {NULL, point, count};
        qtri_paint_contour(surface, &contour, brush);
    } else if (count >= 3) { /* edges are set up once, not in every row */
        qtri_path path;
        qtri_path_init(&path);
        qtri_point last = qtri_hold_point(&point[count - 1]);
        for (int32_t i = 0; i < count; i++) {
            const qtri_point next = qtri_hold_point(&point[i]);
            qtri_path_line(&path, &last, &next);
            last = next;
        }
        qtri_path_paint(&path, surface, brush);
    }
}

void qtri_paint_polygon(const qtri_surface *surface, const qtri_point *point, int32_t count,
                        const qtri_brush *brush)
{
    QTRI_CHECK(check_points(surface, point, count));
    paint_polygon(surface, point, count, brush);
}

/* side width / 2 length, to nearest; |side| <= 2^23, width < 2^23. */
static int32_t offset_of(int32_t side, int32_t width, uint64_t length)
{
    bool half;
    const uint64_t n = qtri_mul_u32(qtri_magnitude32(side), (uint32_t)width);
    const int32_t offset = (int32_t)(qtri_divide64(n, 2 * length, 0, &half) + half);
    return side < 0 ? -offset : offset;
}

void qtri_paint_stroke(const qtri_surface *surface, const qtri_point *from, const qtri_point *to,
                       int32_t width_24p8, const qtri_brush *brush)
{
    QTRI_ASSERT(from != NULL);
    QTRI_ASSERT(to != NULL);
    QTRI_CHECK(check_stroke(surface, *from, *to, width_24p8));
    const qtri_point a = qtri_hold_point(from);
    const qtri_point b = qtri_hold_point(to);
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
    paint_polygon(surface, point, 4, brush);
}
