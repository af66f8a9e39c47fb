/* SPDX-License-Identifier: MIT */
#include "stroke_job.h"

void qtri_stroke_job_init(qtri_stroke_job *job, const qtri_view *view, const qtri_transform *pose,
                          const qtri_corner *corners, uint32_t count, const qtri_stroke *stroke,
                          const qtri_material *material)
{
    qtri_transform object_to_clip;
    qtri_transform_mul(&object_to_clip, &view->camera, pose);
    qtri_transform_mul(&object_to_clip, &view->projection, &object_to_clip);
    qtri_projector_init(&job->projector, &object_to_clip, &view->viewport);
    qtri_projector_set_depth(&job->projector, &view->viewport, material->depth_bias);
    job->corners = corners;
    job->count = count;
    job->vertices = NULL;
    job->kept = 0;
    job->radius = qtri_stroke_radius(stroke->width);
    job->cap = qtri_stroke_cap(stroke);
    job->closed = stroke->closed && count > 2;
}

void qtri_stroke_job_vertex(const qtri_stroke_job *job, uint32_t corner, qtri_vertex *out)
{
    const qtri_vec4 *const position[1] = {&job->corners[corner].position};
    qtri_clip_vertex clip;
    qtri_projector_points(&job->projector, position, 1, &clip);
    const unsigned outcode = qtri_clip_outcode(&clip);
    out->at.x_24p8 = 0;
    out->at.y_24p8 = 0;
    out->depth_16p8 = QTRI_VERTEX_OUTSIDE | outcode;
    if (outcode == 0) {
        qtri_screen_vertex screen;
        qtri_project(&job->projector, &clip, &screen);
        out->at.x_24p8 = screen.x_24p8;
        out->at.y_24p8 = screen.y_24p8;
        out->depth_16p8 = screen.depth_16p16 & ~0xFFu;
    }
}

/* The two corners of a part. */
static void corners_of(const qtri_stroke_job *job, uint32_t part, uint32_t corner[2])
{
    corner[0] = part;
    corner[1] = part + 1 < job->count ? part + 1 : 0;
}

static void find_vertex(const qtri_stroke_job *job, uint32_t corner, qtri_vertex *out)
{
    if (corner < job->kept) {
        *out = job->vertices[corner];
    } else {
        qtri_stroke_job_vertex(job, corner, out);
    }
}

/* The ends of what clipping leaves of a part, as qtri_clip_line has them. False: nothing. */
static bool clip_part(const qtri_stroke_job *job, const uint32_t corner[2], qtri_clip_vertex v[2])
{
    const qtri_vec4 *const position[2] = {&job->corners[corner[0]].position,
                                          &job->corners[corner[1]].position};
    qtri_projector_points(&job->projector, position, 2, v);
    v[0].b1_q30 = 0;
    v[1].b1_q30 = (int32_t)1 << 30;
    const unsigned first = qtri_clip_outcode(&v[0]);
    const unsigned second = qtri_clip_outcode(&v[1]);
    return (first & second) == 0 && qtri_clip_line(v, first | second) != 0;
}

static bool is_inside(const qtri_vertex *v)
{
    return (v->depth_16p8 & QTRI_VERTEX_OUTSIDE) == 0;
}

bool qtri_stroke_job_place(const void *from, uint32_t part, qtri_stroke_place *place)
{
    const qtri_stroke_job *job = from;
    uint32_t corner[2];
    qtri_vertex v[2];
    corners_of(job, part, corner);
    find_vertex(job, corner[0], &v[0]);
    find_vertex(job, corner[1], &v[1]);
    if (is_inside(&v[0]) && is_inside(&v[1])) {
        place->end[0] = v[0].at;
        place->end[1] = v[1].at;
    } else {
        qtri_clip_vertex clip[2];
        if (!clip_part(job, corner, clip)) {
            return false;
        }
        for (int i = 0; i < 2; i++) {
            qtri_screen_vertex screen;
            qtri_project(&job->projector, &clip[i], &screen);
            place->end[i].x_24p8 = screen.x_24p8;
            place->end[i].y_24p8 = screen.y_24p8;
        }
    }
    place->radius_24p8 = job->radius;
    const bool is_first = part == 0 && !job->closed;
    const bool is_last = part + 2 >= job->count && !job->closed;
    place->caps[0] = is_first ? job->cap : QTRI_CAP_ROUND;
    place->caps[1] = is_last ? job->cap : QTRI_CAP_ROUND;
    return true;
}

void qtri_stroke_job_color(qtri_stroke_end *end, const qtri_rgb *color)
{
    end->color_8p16[0] = (int32_t)color->r << 16;
    end->color_8p16[1] = (int32_t)color->g << 16;
    end->color_8p16[2] = (int32_t)color->b << 16;
}

/* Its colour moves towards the other end's by what was cut off. */
static void mix_colors(qtri_stroke_end end[2], const int32_t share_q30[2])
{
    for (int i = 0; i < 3; i++) {
        const int32_t from = end[0].color_8p16[i];
        const int32_t difference = end[1].color_8p16[i] - from;
        for (int k = 0; k < 2; k++) {
            end[k].color_8p16[i] = from + (int32_t)(qtri_mul_s32(difference, share_q30[k]) >> 30);
        }
    }
}

void qtri_stroke_job_ends(const void *from, uint32_t part, qtri_stroke_end end[2])
{
    const qtri_stroke_job *job = from;
    uint32_t corner[2];
    qtri_vertex v[2];
    corners_of(job, part, corner);
    for (int i = 0; i < 2; i++) {
        find_vertex(job, corner[i], &v[i]);
        end[i].depth_16p8 = v[i].depth_16p8;
        qtri_stroke_job_color(&end[i], &job->corners[corner[i]].color);
    }
    if (is_inside(&v[0]) && is_inside(&v[1])) {
        return;
    }
    qtri_clip_vertex clip[2];
    (void)clip_part(job, corner, clip); /* something is left: the part was placed */
    const int32_t share_q30[2] = {clip[0].b1_q30, clip[1].b1_q30};
    for (int i = 0; i < 2; i++) {
        qtri_screen_vertex screen;
        qtri_project(&job->projector, &clip[i], &screen);
        end[i].depth_16p8 = screen.depth_16p16 & ~0xFFu;
    }
    mix_colors(end, share_q30);
}
