/* SPDX-License-Identifier: MIT */
#include "stroke.h"
#include "checked_material.h"

/* A polyline on the screen. */
typedef struct polyline {
    const qtri_screen_vertex *v;
    uint32_t count;
    int32_t radius;
    uint8_t cap;
    bool closed;
} polyline;

static qtri_screen_point point_of(const qtri_screen_vertex *v)
{
    const qtri_screen_point point = {qtri_stroke_hold(v->x_24p8), qtri_stroke_hold(v->y_24p8)};
    return point;
}

static bool place(const void *from, uint32_t part, qtri_stroke_place *out)
{
    const polyline *line = from;
    const uint32_t next = part + 1 < line->count ? part + 1 : 0;
    out->end[0] = point_of(&line->v[part]);
    out->end[1] = point_of(&line->v[line->count == 1 ? 0 : next]);
    out->radius_24p8 = line->radius;
    const bool is_first = part == 0 && !line->closed;
    const bool is_last = part + 2 >= line->count && !line->closed;
    out->caps[0] = is_first ? line->cap : QTRI_CAP_ROUND;
    out->caps[1] = is_last ? line->cap : QTRI_CAP_ROUND;
    return true;
}

static void set_end(qtri_stroke_end *end, const qtri_screen_vertex *v)
{
    const uint32_t farthest = (uint32_t)65535 << 16;
    end->depth_16p8 = v->depth_16p16 < farthest ? v->depth_16p16 : farthest;
    for (int i = 0; i < 3; i++) {
        end->color_8p16[i] = qtri_hold32(v->color_8p16[i], 0, 255 << 16);
    }
}

static void ends(const void *from, uint32_t part, qtri_stroke_end end[2])
{
    const polyline *line = from;
    set_end(&end[0], &line->v[part]);
    set_end(&end[1], &line->v[part + 1 < line->count ? part + 1 : 0]);
}

void qtri_raster_polyline(const qtri_surface *surface, const qtri_material *material,
                          const qtri_stroke *stroke, const qtri_screen_vertex *v, uint32_t count)
{
    QTRI_CHECK(qtri_check_surface(surface));
    QTRI_CHECK(qtri_check_material(material));
    QTRI_CHECK(qtri_check_stroke(stroke));
    QTRI_ASSERT(v != NULL || count == 0);
    qtri_stroker stroker;
    const polyline line = {v, count, qtri_stroke_radius(stroke->width), qtri_stroke_cap(stroke),
                           stroke->closed && count > 2};
    const qtri_stroke_source source = {&line, line.closed || count == 1 ? count : count - 1, place,
                                       ends};
    if (count > 0 && line.radius > 0 && qtri_stroker_init(&stroker, surface, material, stroke)) {
        qtri_stroker_draw(&stroker, &source);
    }
}

void qtri_raster_point(const qtri_surface *surface, const qtri_material *material,
                       const qtri_stroke *stroke, const qtri_screen_vertex *v)
{
    QTRI_CHECK(qtri_check_stroke(stroke));
    QTRI_ASSERT(v != NULL);
    qtri_stroke point = *stroke;
    point.cap = qtri_stroke_cap(stroke) == QTRI_CAP_ROUND ? QTRI_CAP_ROUND : QTRI_CAP_SQUARE;
    qtri_raster_polyline(surface, material, &point, v, 1);
}
