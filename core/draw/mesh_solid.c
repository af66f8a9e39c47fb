/* SPDX-License-Identifier: MIT */
#include "../raster/pixel_light.h"
#include "../raster/sampling.h"
#include "../raster/small.h"
#include "lights.h"
#include "pipeline_ops.h"

/* What not every mesh has. */
QTRI_NOINLINE static void set_more(const qtri_mesh_job *draw, uint32_t index,
                                   uint32_t intensity_q15, qtri_attributes *out)
{
    if (draw->mesh->colors != NULL) {
        qtri_raster_lit_channels(out->color, &draw->primitive.to.solid.raster,
                                 &draw->mesh->colors[index], intensity_q15);
    }
    if (draw->primitive.to.solid.raster.texture != NULL) {
        qtri_mesh_set_uv(&out->u_q32, &out->v_q32, draw->mesh, index);
    }
}

QTRI_NOINLINE static void draw_lit(const qtri_mesh_job *draw, const void *indices,
                                   qtri_vertex *const vertex[3], qtri_triangle *triangle,
                                   uint32_t face_q15)
{
    qtri_attributes attributes[3];
    if (draw->lights != NULL) {
        draw->lights->model->large(draw, indices, vertex, triangle);
        return;
    }
    for (int i = 0; i < 3; i++) {
        uint32_t intensity_q15 = draw->lit_per_vertex ? vertex[i]->intensity_q15 : face_q15;
        qtri_vertex_attributes(&attributes[i], vertex[i], intensity_q15);
        if (draw->more) {
            set_more(draw, qtri_mesh_index(draw->mesh, indices, i), intensity_q15, &attributes[i]);
        }
    }
    qtri_mesh_set_rests(attributes, draw, indices, triangle);
    qtri_triangle_draw(&draw->primitive.to.solid.raster, triangle, attributes);
}

uint32_t qtri_mesh_find_light(const void *from, const void *indices, qtri_vertex *a, qtri_vertex *b,
                              qtri_vertex *c)
{
    const qtri_mesh_job *draw = from;
    if (draw->lit_per_vertex) {
        if (!draw->lit && !qtri_vertices_are_lit(a, b, c)) {
            qtri_mesh_light_corners(draw, indices, a, b, c);
        }
        return QTRI_VERTEX_UNLIT;
    }
    return QTRI_WITH_FACE_LIGHT && draw->lit_per_face ? qtri_mesh_light_face(draw, indices)
                                                      : QTRI_INTENSITY_ONE;
}

/* Lit only when it touches a pixel. */
QTRI_NOINLINE static void draw_large(const qtri_mesh_job *draw, const void *indices, qtri_vertex *a,
                                     qtri_vertex *b, qtri_vertex *c)
{
    qtri_triangle triangle;
    triangle.p[0] = &a->at;
    triangle.p[1] = &b->at;
    triangle.p[2] = &c->at;
    triangle.area = qtri_triangle_area(&a->at, &b->at, &c->at);
    triangle.tinted = draw->tinted;
    if (triangle.area == 0 || !qtri_triangle_begin(&draw->primitive.to.solid.raster, &triangle)) {
        return;
    }
    qtri_vertex *const vertex[3] = {a, b, c};
    draw_lit(draw, indices, vertex, &triangle, qtri_mesh_find_light(draw, indices, a, b, c));
}

/* A small one with colours of its own. */
QTRI_NOINLINE static void draw_colored(const qtri_mesh_job *draw, const uint32_t index[3],
                                       qtri_list_triangle *t)
{
    int32_t color[3][3];
    const qtri_raster *raster = &draw->primitive.to.solid.raster;
    for (int i = 0; i < 3; i++) {
        qtri_raster_lit_channels(color[i], raster, &draw->mesh->colors[index[i]],
                                 draw->lit_per_vertex ? t->v[i]->intensity_q15 : t->light_q15);
    }
    t->color = (const int32_t(*)[3])color;
    qtri_small_draw(raster, t);
}

/* In place where code need not be small. */
#ifdef __OPTIMIZE_SIZE__
#define PLACE  qtri_place_triangle
#define SHARED QTRI_NOINLINE static
#else
#define PLACE  qtri_place_near
#define SHARED QTRI_INLINE
#endif

/* A small one that touches a pixel. */
SHARED void draw_placed(const qtri_mesh_job *draw, const void *indices, qtri_place *place,
                        qtri_vertex *a, qtri_vertex *b, qtri_vertex *c)
{
    qtri_coordinates uv[2];
    const qtri_mesh *mesh = draw->mesh;
    const qtri_raster *raster = &draw->primitive.to.solid.raster;
    const uint32_t light_q15 = raster->lamp.by_vertex && qtri_vertices_are_lit(a, b, c)
                                   ? QTRI_VERTEX_UNLIT
                                   : qtri_mesh_find_light(draw, indices, a, b, c);
    qtri_list_triangle t = {place, {a, b, c}, NULL, light_q15, uv};
    if (draw->more) {
        const uint32_t index[3] = {qtri_mesh_index(mesh, indices, 0),
                                   qtri_mesh_index(mesh, indices, 1),
                                   qtri_mesh_index(mesh, indices, 2)};
        if (raster->texture != NULL) {
            qtri_mesh_set_coordinates(uv, mesh, index);
        }
        if (draw->lights != NULL) {
            draw->lights->model->small(draw, index, &t);
            return;
        }
        if (!draw->tinted) {
            draw_colored(draw, index, &t);
            return;
        }
    }
    qtri_small_draw(raster, &t);
}

/* Whether one with a route may be drawn as a small one. */
static bool may_be_small(const qtri_raster *raster, const qtri_vertex *a, const qtri_vertex *b,
                         const qtri_vertex *c)
{
    return raster->lit == NULL ? qtri_takes_small(raster)
                               : qtri_is_lit_by_vertex(raster, &a->at, &b->at, &c->at);
}

/* The same where triangles have a route: those of samples may be small, and what is lit by pixel
   but for its size. False: it is large. */
QTRI_NOINLINE static bool draw_routed(const qtri_mesh_job *draw, const void *indices,
                                      qtri_vertex *a, qtri_vertex *b, qtri_vertex *c)
{
    qtri_place place;
    uint8_t spans[QTRI_PLACE_SPANS];
    const qtri_raster *raster = &draw->primitive.to.solid.raster;
    qtri_placed placed = QTRI_PLACED_LARGE;
    if (may_be_small(raster, a, b, c)) {
        placed = raster->samples != NULL ? raster->samples->place(&place, spans, raster, a, b, c)
                                         : qtri_place_triangle(&place, spans, raster, a, b, c);
    }
    if (placed == QTRI_PLACED_SMALL) {
        draw_placed(draw, indices, &place, a, b, c);
    }
    return placed != QTRI_PLACED_LARGE;
}

/* One that no fused loop draws. False: it is large, and drawn where this takes no stack. */
QTRI_NOINLINE static bool draw_any(const qtri_mesh_job *draw, const void *indices, qtri_vertex *a,
                                   qtri_vertex *b, qtri_vertex *c)
{
    qtri_place place;
    uint8_t spans[QTRI_PLACE_SPANS];
    const qtri_raster *raster = &draw->primitive.to.solid.raster;
    const qtri_placed placed = PLACE(&place, spans, raster, a, b, c);
    if (placed == QTRI_PLACED_SMALL) {
        draw_placed(draw, indices, &place, a, b, c);
    }
    return placed != QTRI_PLACED_LARGE;
}

QTRI_NOINLINE void qtri_mesh_draw_solid(const qtri_mesh_job *draw, const void *indices,
                                        qtri_vertex *a, qtri_vertex *b, qtri_vertex *c)
{
    const qtri_raster *raster = &draw->primitive.to.solid.raster;
    if (draw->primitive.ops != NULL) {
        draw->primitive.ops->triangle(draw, indices, a, b, c);
        return;
    }
    if (raster->tint_small != NULL && raster->tint_small(raster, indices, a, b, c)) {
        return;
    }
    if (!(raster->route != NULL ? draw_routed(draw, indices, a, b, c)
                                : draw_any(draw, indices, a, b, c))) {
        draw_large(draw, indices, a, b, c);
    }
}
