/* SPDX-License-Identifier: MIT */
/*
 * Points and splats: parts without a length.
 *
 * The size of a splat on the screen is half the distance of the points that lie a width apart
 * around it, along the picture's rows' normal in eye space: the same for any projection.
 */
#include "stroke_job.h"

/* Half a width along what is up in the picture, in object space. */
static qtri_vec3 half_width_up(const qtri_view *view, const qtri_transform *pose, q16 width)
{
    qtri_transform object_to_eye;
    qtri_mat4 m;
    qtri_transform_mul(&object_to_eye, &view->camera, pose);
    qtri_transform_to_mat4(&object_to_eye, &m);
    const qtri_vec3 row = {m.m[1][0], m.m[1][1], m.m[1][2]};
    const qtri_vec3 up = qtri_vec3_normalize(row);
    const qtri_vec3 half = {q16_mul(up.x, width / 2), q16_mul(up.y, width / 2),
                            q16_mul(up.z, width / 2)};
    return half;
}

/* What a splat's half is on the screen: at least a 256th, at most QTRI_STROKE_WIDTH_MAX / 2. */
static int32_t radius_in_space(const qtri_stroke_job *job, const qtri_vec4 *center,
                               const qtri_vec3 *half, const qtri_screen_point *at)
{
    const int32_t most = QTRI_STROKE_WIDTH_MAX * 128;
    qtri_vec4 rim = *center;
    qtri_clip_vertex clip;
    qtri_screen_vertex screen;
    rim.x = qtri_saturate32((int64_t)rim.x + qtri_mul_s32(half->x, rim.w) / 65536);
    rim.y = qtri_saturate32((int64_t)rim.y + qtri_mul_s32(half->y, rim.w) / 65536);
    rim.z = qtri_saturate32((int64_t)rim.z + qtri_mul_s32(half->z, rim.w) / 65536);
    const qtri_vec4 *const position[1] = {&rim};
    qtri_projector_points(&job->projector, position, 1, &clip);
    if ((qtri_clip_outcode(&clip) & ~(unsigned)QTRI_OUT_FAR) != 0) {
        return most;
    }
    qtri_project(&job->projector, &clip, &screen);
    /* Below 2^23 each. */
    const int64_t x = (int64_t)screen.x_24p8 - at->x_24p8;
    const int64_t y = (int64_t)screen.y_24p8 - at->y_24p8;
    const uint64_t radius = qtri_sqrt64_round((uint64_t)(x * x) + (uint64_t)(y * y));
    return radius > (uint64_t)most ? most : qtri_greatest32((int32_t)radius, 1);
}

void qtri_draw_points(const qtri_surface *surface, const qtri_view *view,
                      const qtri_transform *pose, const qtri_corner *corners, uint32_t corner_count,
                      const qtri_stroke *stroke, const qtri_material *material)
{
    QTRI_CHECK(qtri_check_surface(surface));
    QTRI_CHECK(qtri_check_material(material));
    QTRI_CHECK(qtri_check_view(view, pose));
    QTRI_CHECK(qtri_check_stroke(stroke));
    QTRI_CHECK(qtri_check_corners(corners, corner_count, 1));
    qtri_stroke_job job;
    qtri_stroker stroker;
    qtri_vec3 half = {0, 0, 0};
    qtri_stroke_place place;
    qtri_stroke_end end[2];
    if (stroke->width <= 0 || !qtri_stroker_init(&stroker, surface, material, stroke)) {
        return;
    }
    qtri_stroke_job_init(&job, view, pose, corners, corner_count, stroke, material);
    if (stroke->in_space) {
        half = half_width_up(view, pose, stroke->width);
    } else if (job.radius == 0) {
        return;
    }
    place.radius_24p8 = job.radius;
    place.caps[0] = job.cap == QTRI_CAP_ROUND ? QTRI_CAP_ROUND : QTRI_CAP_SQUARE;
    place.caps[1] = place.caps[0];
    for (uint32_t i = 0; i < corner_count; i++) {
        qtri_vertex v;
        qtri_stroke_job_vertex(&job, i, &v);
        if ((v.depth_16p8 & QTRI_VERTEX_OUTSIDE) != 0) {
            continue;
        }
        place.end[0] = v.at;
        place.end[1] = v.at;
        end[0].depth_16p8 = v.depth_16p8;
        qtri_stroke_job_color(&end[0], &corners[i].color);
        end[1] = end[0];
        qtri_stroke_look_init(&stroker.look, end);
        if (stroke->in_space) {
            place.radius_24p8 = radius_in_space(&job, &corners[i].position, &half, &v.at);
        }
        qtri_stroker_draw_part(&stroker, &place);
    }
}
