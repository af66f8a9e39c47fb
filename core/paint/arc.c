/* SPDX-License-Identifier: MIT */
#include "paint_checked.h"
#include "path.h"

#include "qtri/q16_trig.h"

#include "../bits/bits.h"

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

/* Clockwise from one angle to another, 0 <= from < 360 and from < to < from + 360 degrees. */
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

static void add_line(qtri_path *path, const qtri_point *center, int32_t inner, int32_t outer,
                     q16 angle)
{
    const qtri_point from = point_at(center, inner, angle);
    const qtri_point to = point_at(center, outer, angle);
    qtri_path_line(path, &from, &to);
}

void qtri_paint_arc(const qtri_surface *surface, const qtri_point *center, int32_t radius_24p8,
                    int32_t width_24p8, q16 from, q16 sweep, const qtri_brush *brush)
{
    QTRI_CHECK(qtri_check_circle(surface, center, radius_24p8));
    QTRI_CHECK(qtri_check_ring_width(radius_24p8, width_24p8));
    if (sweep >= DEGREES(360) || sweep <= -DEGREES(360)) {
        qtri_paint_ring_part(surface, center, radius_24p8, width_24p8, brush);
        return;
    }
    if (radius_24p8 <= 0 || width_24p8 <= 0 || sweep == 0) {
        return;
    }
    const qtri_point held = {qtri_hold_24p8(center->x_24p8), qtri_hold_24p8(center->y_24p8)};
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
    add_line(&path, &held, inner, outer, from);
    path.direction = -1;
    add_line(&path, &held, inner, outer, to);
    if (inner > 0) {
        add_arc(&path, &held, inner, from, to);
    }
    qtri_path_paint(&path, surface, brush);
}
