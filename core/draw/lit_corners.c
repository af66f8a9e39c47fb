/* SPDX-License-Identifier: MIT */
#include "lit_corners.h"

#include "../geometry/lit_point.h"
#include "per_pixel.h"
#include "checked.h"

/* The sign of the homogeneous determinant; y points down. */
bool qtri_clipped_is_back(const qtri_clip_vertex v[3])
{
    qtri_wide p[3][3];
    qtri_wide cross[3];
    for (int i = 0; i < 3; i++) {
        qtri_wide_set(&p[i][0], v[i].x, 0);
        qtri_wide_set(&p[i][1], v[i].y, 0);
        qtri_wide_set(&p[i][2], v[i].w, 0);
    }
    qtri_wide_cross(cross, p[0], p[1]);
    qtri_wide sum = qtri_wide_mul(cross[0], p[2][0]);
    qtri_wide_add_product(&sum, &cross[1], &p[2][1]);
    qtri_wide_add_product(&sum, &cross[2], &p[2][2]);
    return sum.m > 0;
}

static qtri_vec3 place_of(const qtri_vec4 *position)
{
    qtri_vec3 place = {position->x, position->y, position->z};
    if (position->w != Q16_ONE) {
        place.x = q16_div(place.x, position->w);
        place.y = q16_div(place.y, position->w);
        place.z = q16_div(place.z, position->w);
    }
    return place;
}

/* All triangles of a call. */
typedef struct lit_call {
    qtri_corners c;
    const qtri_illumination *by;
    const qtri_corner *corners;
    const qtri_normal *normals;
    uint32_t corner_count;
} lit_call;

/* Triangle `first` / 3 with its colours in the light. */
static void light(qtri_corner lit[3], const lit_call *call, uint32_t first, bool is_back)
{
    const qtri_corner *corners = &call->corners[first];
    const qtri_normal *normals = call->normals != NULL ? &call->normals[first] : NULL;
    const qtri_primitive *primitive = &call->c.job.primitive;
    const bool smooth = qtri_is_smooth(primitive->material);
    const qtri_by_pixel *by_pixel = qtri_by_pixel_of(primitive->material);
    const int32_t turn = is_back ? -1 : 1;
    const qtri_vec3 p[3] = {place_of(&corners[0].position), place_of(&corners[1].position),
                            place_of(&corners[2].position)};
    const qtri_vec3 mean = {qtri_third(p[0].x) + qtri_third(p[1].x) + qtri_third(p[2].x),
                            qtri_third(p[0].y) + qtri_third(p[1].y) + qtri_third(p[2].y),
                            qtri_third(p[0].z) + qtri_third(p[1].z) + qtri_third(p[2].z)};
    int32_t face[3];
    qtri_face_normal(face, &p[0], &p[1], &p[2]);
    for (int i = 0; i < 3; i++) {
        int32_t n[3] = {face[0], face[1], face[2]};
        qtri_lit_point point;
        if (smooth && normals != NULL && (normals[i].x | normals[i].y | normals[i].z) != 0) {
            n[0] = normals[i].x;
            n[1] = normals[i].y;
            n[2] = normals[i].z;
        }
        lit[i] = corners[i];
        qtri_illuminated_normal(&point, call->by, turn * n[0], turn * n[1], turn * n[2]);
        qtri_illuminated_place(&point, call->by, smooth ? &p[i] : &mean);
        if (by_pixel != NULL) {
            by_pixel->set(primitive, i, &point, &corners[i].color);
        }
        lit[i].color = qtri_lit_rgb(qtri_illuminate(call->by, &point, &corners[i].color));
    }
}

static void draw_lit(lit_call *call, uint32_t first)
{
    const bool two_sided = call->by->two_sided;
    const qtri_corner *corners = &call->corners[first];
    const qtri_corners_fate found = qtri_corners_place(&call->c, corners, first);
    qtri_corner lit[3];
    if (found == QTRI_CORNERS_SEEN) {
        const qtri_vertex *v = call->c.job.vertices;
        light(lit, call, first, two_sided && qtri_triangle_area(&v[0].at, &v[1].at, &v[2].at) > 0);
        qtri_corners_draw(&call->c, lit);
    } else if (found == QTRI_CORNERS_ELSEWHERE) {
        qtri_shape shape;
        qtri_corners_fetch(&call->c.job.primitive, corners, 3, shape.clip);
        light(lit, call, first, two_sided && qtri_clipped_is_back(shape.clip));
        qtri_corners_draw_clipped(&call->c, &shape, lit);
    }
}

static void draw_all(void *with)
{
    lit_call *call = with;
    for (uint32_t i = 0; call->corner_count - i >= 3; i += 3) {
        draw_lit(call, i);
    }
}

/* Apart, or its stack would be beneath that of qtri_draw_triangles(). */
QTRI_NOINLINE static void draw_call(const qtri_surface *surface, const qtri_view *view,
                                    const qtri_transform *pose, const qtri_corner *corners,
                                    const qtri_normal *normals, uint32_t corner_count,
                                    const qtri_material *material)
{
    lit_call call;
    qtri_illumination illumination;
    const qtri_by_pixel *by_pixel = qtri_by_pixel_of(material);
    qtri_corners_init(&call.c, surface, view, pose, material,
                      by_pixel != NULL           ? QTRI_BY_PIXEL
                      : qtri_is_smooth(material) ? QTRI_COLORS
                                                 : QTRI_TINT);
    qtri_illumination_init(&illumination, view, pose, material->reflection, NULL);
    call.by = &illumination;
    call.corners = corners;
    call.normals = normals;
    call.corner_count = corner_count;
    if (by_pixel != NULL) {
        by_pixel->run(&call.c.job.primitive, &illumination, draw_all, &call);
    } else {
        draw_all(&call);
    }
}

void qtri_draw_lit_triangles(const qtri_surface *surface, const qtri_view *view,
                             const qtri_transform *pose, const qtri_corner *corners,
                             const qtri_normal *normals, uint32_t corner_count,
                             const qtri_material *material)
{
    QTRI_CHECK(qtri_check_surface(surface));
    QTRI_CHECK(qtri_check_material(material));
    QTRI_CHECK(qtri_check_view(view, pose));
    QTRI_CHECK(qtri_check_corners(corners, corner_count, 3));
    if (view->lights == NULL) {
        qtri_draw_triangles(surface, view, pose, corners, corner_count, material);
    } else {
        draw_call(surface, view, pose, corners, normals, corner_count, material);
    }
}
