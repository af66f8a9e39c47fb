/* SPDX-License-Identifier: MIT */
/*
 * A triangle of a mesh whose vertices are transformed: whether it faces away, and its way to the
 * rasterizer, or to a fill.
 */
#include "fill.h"
#include "qtri/body/pixel.h"
#include "lights.h"

/* What light makes of the corners' colours. */
static void light_triangle(uint32_t intensity_q15[3], const qtri_mesh_job *draw,
                           const void *triangle, qtri_vertex *const vertex[3])
{
    uint32_t face_q15 = QTRI_WITH_FACE_LIGHT && draw->lit_per_face
                            ? qtri_mesh_light_face(draw, triangle)
                            : QTRI_INTENSITY_ONE;
    if (draw->lit_per_vertex) {
        qtri_mesh_light_corners(draw, triangle, vertex[0], vertex[1], vertex[2]);
    }
    for (int i = 0; i < 3; i++) {
        intensity_q15[i] = draw->lit_per_vertex ? vertex[i]->intensity_q15 : face_q15;
    }
}

/* One that is clipped: lit before, where the stack is not deep. */
typedef struct lit_triangle {
    const qtri_mesh_job *draw;
    const void *indices;
    uint32_t intensity_q15[3];
} lit_triangle;

/* Its colours and texture coordinates. */
static void set_attributes(const void *from, qtri_screen_vertex out[3])
{
    const lit_triangle *triangle = from;
    const qtri_mesh_job *draw = triangle->draw;
    for (int i = 0; i < 3; i++) {
        uint32_t index = qtri_mesh_index(draw->mesh, triangle->indices, i);
        qtri_mesh_set_color(out[i].color_8p16, draw, index, triangle->intensity_q15[i]);
        if (draw->material.fill == NULL && qtri_is_lit(&draw->primitive.to.solid.state.options)) {
            out[i].color_8p16[0] = (int32_t)triangle->intensity_q15[i] * 510; /* 255.0 is 1 */
        }
        qtri_mesh_set_uv(&out[i].u_q32, &out[i].v_q32, draw->mesh, index);
    }
}

/* Rare: homogeneous coordinates are not kept but computed again. */
QTRI_NOINLINE static void draw_clipped(const qtri_mesh_job *draw, const void *indices,
                                       qtri_vertex *const vertex[3])
{
    if (qtri_mesh_is_outside(vertex)) {
        return;
    }
    qtri_shape shape;
    lit_triangle triangle;
    const qtri_projector *projector = &draw->primitive.projector;
    for (int i = 0; i < 3; i++) {
        uint32_t index = qtri_mesh_index(draw->mesh, indices, i);
        if (qtri_mesh_has_compact(draw->mesh->positions16)) {
            qtri_projector_point16(projector, &draw->mesh->positions16[index], &shape.clip[i]);
        } else {
            qtri_projector_point(projector, &draw->mesh->positions[index], &shape.clip[i]);
        }
    }
    if (draw->material.fill == NULL) { /* whose alphas the vertices have */
        qtri_mesh_indices(draw->primitive.to.solid.small.state->alpha_index, indices,
                          qtri_mesh_has_bytes(draw->mesh));
    }
    if (draw->lights != NULL) {
        draw->lights->model->clipped(draw, indices, &shape);
        return;
    }
    triangle.draw = draw;
    triangle.indices = indices;
    light_triangle(triangle.intensity_q15, draw, indices, vertex);
    qtri_primitive_triangle(&draw->primitive, &shape, set_attributes, &triangle);
}

QTRI_NOINLINE void qtri_mesh_draw_seen(const qtri_mesh_job *draw, const void *indices,
                                       qtri_vertex *const vertex[3])
{
    if (!qtri_mesh_is_inside(vertex[0], vertex[1], vertex[2])) {
        draw_clipped(draw, indices, vertex);
    } else if (draw->material.fill != NULL) {
        draw->material.fill->triangle(draw, indices, vertex);
    } else {
        qtri_mesh_draw_solid(draw, indices, vertex[0], vertex[1], vertex[2]);
    }
}

QTRI_NOINLINE bool qtri_mesh_turned_away(const qtri_mesh_job *draw, const qtri_vertex *a,
                                         const qtri_vertex *b, const qtri_vertex *c)
{
    return qtri_mesh_is_inside(a, b, c) &&
           qtri_is_culled(draw->material.cull, qtri_triangle_area(&a->at, &b->at, &c->at));
}
