/* SPDX-License-Identifier: MIT */
/* Light computed by pixel, &qtri_per_pixel: see qtri_by_pixel in primitive.h. */
#include "qtri/pipeline_make.h"

#include "mesh_job.h"

/* The normal of a triangle. */
static void get_face_normal(int32_t n[3], const qtri_mesh *mesh, const uint32_t index[3])
{
    qtri_vec3 p[3];
    qtri_mesh_positions(p, mesh, index);
    qtri_face_normal(n, &p[0], &p[1], &p[2]);
}

static void set_corner(const qtri_primitive *primitive, int i, const qtri_lit_point *point,
                       const qtri_rgb *color)
{
    qtri_lit_set_corner(qtri_large_light_triangle(primitive->to.solid.small.state), i, point,
                        color);
}

static void set_corners(const qtri_mesh_job *draw, const void *indices, bool is_back)
{
    const qtri_mesh *mesh = draw->mesh;
    const int32_t turn = is_back ? -1 : 1;
    qtri_lit_triangle *lit = qtri_large_light_triangle(draw->primitive.to.solid.small.state);
    uint32_t index[3];
    int32_t n[3];
    if (lit->indices == indices) { /* has_linear_light() has set it up */
        return;
    }
    lit->indices = indices;
    qtri_mesh_indices(index, indices, qtri_mesh_has_bytes(mesh));
    if (!draw->shaded_per_vertex) {
        get_face_normal(n, mesh, index);
    }
    for (int i = 0; i < 3; i++) {
        qtri_lit_point point;
        if (draw->shaded_per_vertex) {
            qtri_lit_vertex_normal(n, mesh, index[i]);
        }
        qtri_illuminated_normal(&point, draw->illumination, turn * n[0], turn * n[1], turn * n[2]);
        qtri_lit_vertex_place(&point, draw, index[i]);
        set_corner(&draw->primitive, i, &point, qtri_mesh_color(draw, index[i]));
    }
}

/* See qtri_draw_state.has_linear_light. A back face has exchanged its vertices 1 and 2. */
static bool has_linear_light(const qtri_small *t)
{
    const qtri_mesh_job *draw = t->from;
    uint32_t index[3];
    if (draw->illumination == NULL) { /* called by qtri_draw_lit_triangles() */
        return false;
    }
    qtri_mesh_indices(index, t->indices, qtri_mesh_has_bytes(draw->mesh));
    set_corners(draw, t->indices, draw->illumination->two_sided && t->index[1] != index[1]);
    return qtri_large_light_is_linear(t->state);
}

static void run(qtri_primitive *primitive, const qtri_illumination *by, qtri_lit_body body,
                void *with)
{
    primitive->to.solid.state.has_linear_light = has_linear_light;
    qtri_large_light_run(&primitive->to.solid.state, by, body, with);
}

/* The pipelines that most programs need: RGB565; preferred to a view's generic one. */
#define BY_PIXEL                                                                                   \
    .format = QTRI_RGB565, .depth = QTRI_LINEAR16, .compare = QTRI_LESS, .shade = QTRI_COLORS,     \
    .per_pixel = 1

QTRI_PIPELINE(qtri_pipeline_by_pixel, BY_PIXEL)
QTRI_PIPELINE(qtri_pipeline_texture_by_pixel, BY_PIXEL, .texel = QTRI_TEXEL_RGB565)

const qtri_pipeline *const qtri_pipelines_by_pixel[] = {&qtri_pipeline_by_pixel,
                                                        &qtri_pipeline_texture_by_pixel, NULL};

static const qtri_by_pixel by_pixel = {qtri_pipelines_by_pixel, run, set_corners, set_corner};

const qtri_shading qtri_per_pixel = {2, true, &by_pixel};
