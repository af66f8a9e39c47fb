/* SPDX-License-Identifier: MIT */
/* Triangles of meshes that are filled: small ones, and large ones. */
#include "large_piece.h"
#include "lights.h"
#include "mesh_job.h"

void qtri_mesh_set_uv(int64_t *u_q32, int64_t *v_q32, const qtri_mesh *mesh, uint32_t index)
{
    if (mesh->uvs16 != NULL) {
        *u_q32 = mesh->uvs16[index].x * ((int64_t)1 << 18);
        *v_q32 = mesh->uvs16[index].y * ((int64_t)1 << 18);
    } else if (mesh->uvs != NULL) {
        *u_q32 = (int64_t)mesh->uvs[index].x * 65536;
        *v_q32 = (int64_t)mesh->uvs[index].y * 65536;
    } else {
        *u_q32 = 0;
        *v_q32 = 0;
    }
}

void qtri_mesh_set_color(int32_t color_8p16[3], const qtri_mesh_job *draw, uint32_t index,
                         uint32_t intensity_q15)
{
    const qtri_rgb *color =
        draw->mesh->colors != NULL ? &draw->mesh->colors[index] : &draw->material.color;
    int32_t intensity = (int32_t)intensity_q15 * 2;
    color_8p16[0] = color->r * intensity; /* <= 255.0 */
    color_8p16[1] = color->g * intensity;
    color_8p16[2] = color->b * intensity;
}

/* Those of its vertices in a view's lights; by pixel, shares of corners. */
static void set_lit_colors(qtri_large_vertex v[3], const qtri_draw_state *state)
{
    if (state->options.per_pixel) {
        for (int i = 0; i < 3; i++) {
            v[i].color_8p16[0] = (int32_t)(i == 1) << 30;
            v[i].color_8p16[1] = (int32_t)(i == 2) << 30;
            v[i].color_8p16[2] = 0;
        }
        return;
    }
    for (int i = 0; i < 3; i++) {
        v[i].color_8p16[0] = (int32_t)(state->lit[i] & 0xFF0000u);
        v[i].color_8p16[1] = (int32_t)(state->lit[i] << 8 & 0xFF0000u);
        v[i].color_8p16[2] = (int32_t)(state->lit[i] << 16 & 0xFF0000u);
    }
}

/* The triangle's colour, or those of its vertices in light. */
static void set_colors(qtri_large_vertex v[3], const qtri_mesh_job *draw, const uint32_t index[3],
                       qtri_vertex *const vertex[3], uint32_t face_q15)
{
    for (int i = 0; i < 3; i++) {
        const uint32_t light_q15 = draw->lit_per_vertex ? vertex[i]->intensity_q15 : face_q15;
        v[i].light_q15 = light_q15;
        qtri_mesh_set_color(v[i].color_8p16, draw, index[i], light_q15);
    }
}

static void set_place(qtri_large_vertex *out, const qtri_vertex *vertex)
{
    out->depth_16p16 = vertex->depth_16p8 & ~0xFFu;
    out->inv_w_q31 = vertex->inv_w;
    out->inv_w_exponent = (int32_t)(vertex->depth_16p8 & 0xFFu);
    out->rest[0] = 0;
    out->rest[1] = 0;
}

QTRI_NOINLINE static void draw_lit(const qtri_mesh_job *draw, const uint32_t index[3],
                                   qtri_vertex *const vertex[3],
                                   const qtri_screen_point *const p[3], int64_t area,
                                   uint32_t face_q15)
{
    qtri_draw_state *state = draw->primitive.to.solid.small.state;
    const uint8_t *alphas = state->material->alphas;
    qtri_large_vertex v[3];
    for (int i = 0; i < 3; i++) {
        set_place(&v[i], vertex[i]);
        if (state->texture != NULL) {
            qtri_mesh_set_uv(&v[i].u_q32, &v[i].v_q32, draw->mesh, index[i]);
        }
        v[i].alpha_q16 =
            state->options.vertex_alpha ? ((uint32_t)alphas[index[i]] << 16) / 255 : 65536;
    }
    if (state->is_lit || state->options.per_pixel) {
        set_lit_colors(v, state);
    } else {
        set_colors(v, draw, index, vertex, face_q15);
    }
    qtri_mesh_find_rests(v, draw, index, p, area);
    qtri_large_triangle(state, p, area,
                        qtri_color_word(v[qtri_provoking_of(&draw->material)].color_8p16), v);
}

QTRI_NOINLINE void qtri_mesh_draw_large(const qtri_mesh_job *draw, const void *indices,
                                        qtri_vertex *a, qtri_vertex *b, qtri_vertex *c)
{
    const qtri_screen_point *const p[3] = {&a->at, &b->at, &c->at};
    qtri_vertex *const vertex[3] = {a, b, c};
    const int64_t area = qtri_triangle_area(p[0], p[1], p[2]);
    uint32_t index[3];
    if (area == 0 || qtri_is_beside(&draw->primitive.to.solid.state, p)) {
        return;
    }
    qtri_mesh_indices(index, indices, qtri_mesh_has_bytes(draw->mesh));
    draw_lit(draw, index, vertex, p, area,
             draw->find_large_light != NULL ? draw->find_large_light(draw, indices, a, b, c)
                                            : QTRI_INTENSITY_ONE);
}

void qtri_mesh_draw_solid(const qtri_mesh_job *draw, const void *indices, qtri_vertex *a,
                          qtri_vertex *b, qtri_vertex *c)
{
    uint32_t index[3];
    qtri_vertex *const vertex[3] = {a, b, c};
    qtri_small t = draw->primitive.to.solid.small;
    qtri_mesh_indices(index, indices, qtri_mesh_has_bytes(draw->mesh));
    if (!qtri_mesh_draw_small(t.state->small, &t, indices, index, vertex)) {
        qtri_mesh_draw_large(draw, indices, a, b, c);
    }
}

/* Those of a mesh whose back faces are culled, no vertex outside, by a pipeline. */
static inline void draw_whole_of(const qtri_mesh_job *draw, const void *triangles, bool narrow)
{
    qtri_small t = draw->primitive.to.solid.small;
    bool (*const by)(qtri_small *) = t.state->small;
    const uint32_t count = draw->mesh->vertex_count;
    const uint32_t size = narrow ? 3 : 6;
    const uint8_t *triangle = triangles;
    const uint8_t *end = triangle + draw->mesh->triangle_count * size;
    const uint32_t vertex_size = qtri_vertex_size();
    for (; triangle != end; triangle += size) {
        uint32_t index[3];
        qtri_vertex *vertex[3];
        qtri_mesh_indices(index, triangle, narrow);
        if (qtri_mesh_find(vertex, draw->vertices, count, index, vertex_size) &&
            !qtri_mesh_draw_small(by, &t, triangle, index, vertex) &&
            !qtri_triangle_is_back(&vertex[0]->at, &vertex[1]->at, &vertex[2]->at)) {
            qtri_mesh_draw_large(draw, triangle, vertex[0], vertex[1], vertex[2]);
        }
    }
}

QTRI_NOINLINE static void draw_wide(const qtri_mesh_job *draw)
{
    draw_whole_of(draw, draw->mesh->triangles, false);
}

QTRI_NOINLINE static void draw_narrow(const qtri_mesh_job *draw)
{
    draw_whole_of(draw, draw->mesh->triangles8, true);
}

void qtri_mesh_draw_whole(const qtri_mesh_job *draw)
{
    if (qtri_mesh_has_bytes(draw->mesh)) {
        draw_narrow(draw);
    } else {
        draw_wide(draw);
    }
}

void qtri_mesh_solid_init(qtri_mesh_job *draw, qtri_light_finder *light)
{
    qtri_small *t = &draw->primitive.to.solid.small;
    t->mesh = draw->mesh;
    t->light = light;
    t->from = draw;
    t->light_q15 = QTRI_VERTEX_UNLIT;
    draw->find_large_light = light;
    if (draw->lights != NULL) {
        draw->primitive.to.solid.state.is_lit = true;
        t->light = draw->lights->model->find;
        draw->find_large_light = draw->lights->model->find_large;
    }
}
