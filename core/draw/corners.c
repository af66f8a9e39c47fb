/* SPDX-License-Identifier: MIT */
#include "checked.h"
#include "corners.h"

static void attributes_of(qtri_screen_vertex *out, const qtri_corner *corner)
{
    out->color_8p16[0] = (int32_t)corner->color.r << 16;
    out->color_8p16[1] = (int32_t)corner->color.g << 16;
    out->color_8p16[2] = (int32_t)corner->color.b << 16;
    out->u_q32 = (int64_t)corner->uv.x * 65536;
    out->v_q32 = (int64_t)corner->uv.y * 65536;
}

void qtri_corners_attributes(const void *from, qtri_screen_vertex attributes[3])
{
    const qtri_corner *corners = from;
    for (int i = 0; i < 3; i++) {
        attributes_of(&attributes[i], &corners[i]);
    }
}

void qtri_corners_fetch(const qtri_primitive *primitive, const qtri_corner *corners, int count,
                        qtri_clip_vertex v[3])
{
    const qtri_vec4 *position[3];
    for (int i = 0; i < count; i++) {
        position[i] = &corners[i].position;
    }
    qtri_projector_points(&primitive->projector, position, count, v);
}

static inline bool is_at(const qtri_vec4 *a, const qtri_vec4 *b)
{
    return a->x == b->x && a->y == b->y && a->z == b->z;
}

/* The vertex of three corners that is at this position; NULL: none. */
static inline const qtri_vertex *find_vertex(const qtri_vertex v[3], const qtri_corner *corners,
                                             const qtri_vec4 *position)
{
    if (is_at(&corners[2].position, position)) { /* fans and strips share these */
        return &v[2];
    }
    if (is_at(&corners[0].position, position)) {
        return &v[0];
    }
    return is_at(&corners[1].position, position) ? &v[1] : NULL;
}

QTRI_NOINLINE qtri_corners_fate qtri_corners_place(const qtri_primitive *primitive,
                                                   qtri_corner_vertices *kept,
                                                   const qtri_corner *corners,
                                                   qtri_fan_vertex fan[3])
{
    const qtri_vertex *before = kept->before;
    qtri_vertex *v = kept->vertex[before == kept->vertex[0]];
    kept->before = NULL;
    qtri_vec3 p[3];
    uint32_t count = 0;
    for (uint32_t i = 0; i < 3; i++) {
        const qtri_vec4 *position = &corners[i].position;
        if (position->w != Q16_ONE) {
            return QTRI_CORNERS_ELSEWHERE;
        }
        const qtri_vertex *same =
            before != NULL ? find_vertex(before, corners - 3, position) : NULL;
        if (same != NULL) {
            v[i] = *same;
            continue;
        }
        p[i].x = position->x;
        p[i].y = position->y;
        p[i].z = position->z;
        v[count++].index = (uint16_t)i;
    }
    if (count != 0 && !qtri_projector_list(&primitive->projector, p, count, v)) {
        return QTRI_CORNERS_ELSEWHERE;
    }
    kept->before = v;
    const int64_t area = qtri_triangle_area(&v[0].at, &v[1].at, &v[2].at);
    if (area == 0 || qtri_is_culled(primitive->material->cull, area)) {
        return QTRI_CORNERS_CULLED;
    }
    for (int i = 0; i < 3; i++) {
        fan[i].at = v[i].at;
        fan[i].depth_16p8 = v[i].depth_16p8;
        fan[i].inv_w_q31 = v[i].inv_w;
        fan[i].b1_q30 = i == 1 ? (int32_t)1 << 30 : 0;
        fan[i].b2_q30 = i == 2 ? (int32_t)1 << 30 : 0;
        fan[i].rest[0] = 0;
        fan[i].rest[1] = 0;
    }
    return QTRI_CORNERS_SEEN;
}

/* Apart, as the wide coordinates take stack that most triangles do without. */
QTRI_NOINLINE static void set_rests(const qtri_primitive *primitive, qtri_fan_vertex fan[3],
                                    const qtri_corner *corners)
{
    for (int i = 0; i < 3; i++) {
        const qtri_vec4 *position = &corners[i].position;
        const qtri_vec3 p = {position->x, position->y, position->z};
        qtri_clip_vertex clip;
        qtri_projector_point(&primitive->projector, &p, &clip);
        qtri_project_rest(fan[i].rest, &clip, &fan[i].at, fan[i].inv_w_q31);
    }
}

void qtri_corners_draw(const qtri_primitive *primitive, qtri_fan_vertex fan[3],
                       const qtri_corner *corners, const qtri_corner *attributes)
{
    if (!qtri_primitive_inside(primitive, fan, qtri_corners_attributes, attributes)) {
        set_rests(primitive, fan, corners);
        qtri_primitive_large(primitive, fan, qtri_corners_attributes, attributes);
    }
}

void qtri_draw_triangles(const qtri_surface *surface, const qtri_view *view,
                         const qtri_transform *pose, const qtri_corner *corners,
                         uint32_t corner_count, const qtri_material *material)
{
    QTRI_CHECK(qtri_check_surface(surface));
    QTRI_CHECK(qtri_check_material(material));
    QTRI_CHECK(qtri_check_view(view, pose));
    QTRI_CHECK(qtri_check_corners(corners, corner_count, 3));
    qtri_primitive primitive;
    qtri_primitive_init(&primitive, surface, view, pose, material,
                        qtri_is_smooth(material) ? QTRI_COLORS : QTRI_TINT);
    const bool solid = material->fill == NULL;
    qtri_corner_vertices kept;
    kept.before = NULL;
    for (uint32_t i = 0; corner_count - i >= 3; i += 3) {
        qtri_shape shape;
        qtri_primitive_note(&primitive, i);
        const qtri_corners_fate found =
            solid ? qtri_corners_place(&primitive, &kept, &corners[i], shape.fan)
                  : QTRI_CORNERS_ELSEWHERE;
        if (found == QTRI_CORNERS_SEEN) {
            qtri_corners_draw(&primitive, shape.fan, &corners[i], &corners[i]);
        } else if (found == QTRI_CORNERS_ELSEWHERE) {
            qtri_corners_fetch(&primitive, &corners[i], 3, shape.clip);
            qtri_primitive_triangle(&primitive, &shape, qtri_corners_attributes, &corners[i]);
        }
    }
    qtri_primitive_finish(&primitive);
}

void qtri_draw_lines(const qtri_surface *surface, const qtri_view *view, const qtri_transform *pose,
                     const qtri_corner *corners, uint32_t corner_count,
                     const qtri_material *material)
{
    QTRI_CHECK(qtri_check_surface(surface));
    QTRI_CHECK(qtri_check_material(material));
    QTRI_CHECK(qtri_check_view(view, pose));
    QTRI_CHECK(qtri_check_corners(corners, corner_count, 2));
    qtri_primitive primitive;
    primitive.surface = surface;
    primitive.material = material;
    qtri_primitive_place(&primitive, view, pose);
    qtri_primitive_begin_lines(&primitive);
    for (uint32_t i = 0; corner_count - i >= 2; i += 2) {
        qtri_clip_vertex v[3];
        qtri_screen_vertex attributes[2];
        qtri_corners_fetch(&primitive, &corners[i], 2, v);
        attributes_of(&attributes[0], &corners[i]);
        attributes_of(&attributes[1], &corners[i + 1]);
        qtri_primitive_line(&primitive, v, attributes);
    }
    qtri_primitive_finish_lines(&primitive);
}
