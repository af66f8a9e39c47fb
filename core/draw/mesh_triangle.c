/* SPDX-License-Identifier: MIT */
/*
 * One triangle of a mesh, its vertices transformed: lights it, and passes it to the pipeline, the
 * clipper or the material's fill.
 */
#include "lights.h"

/* ---- Light ---- */

/* The triangle's index, a third of the offset of its indices: 3 * 0xAAAAAAAB is 1 modulo 2^32. */
static uint32_t triangle_index(const qtri_mesh *mesh, const void *indices)
{
    const uint8_t *at = indices;
    const uint32_t offset = qtri_mesh_has_bytes(mesh)
                                ? (uint32_t)(at - (const uint8_t *)mesh->triangles8)
                                : (uint32_t)(at - (const uint8_t *)mesh->triangles) / 2;
    return offset * 0xAAAAAAABu;
}

uint32_t qtri_mesh_light_face(const qtri_mesh_job *draw, const void *indices)
{
    uint32_t index[3];
    qtri_mesh_indices(index, indices, qtri_mesh_has_bytes(draw->mesh));
    return draw->stage->face_light->face(&draw->of.mesh.lighting, draw->mesh,
                                         triangle_index(draw->mesh, indices), index);
}

static inline void light_unlit_vertex(const qtri_mesh_job *draw, uint32_t index,
                                      qtri_vertex *vertex)
{
    if (vertex->intensity_q15 != QTRI_VERTEX_UNLIT) {
        return;
    }
    vertex->intensity_q15 = QTRI_INTENSITY_ONE;
    if (draw->lit_per_vertex) {
        vertex->intensity_q15 =
            (uint16_t)draw->stage->vertex_light->vertex(&draw->of.mesh.lighting, draw->mesh, index);
    }
}

QTRI_NOINLINE void qtri_mesh_light_vertices(const qtri_mesh_job *draw, const void *indices,
                                            qtri_vertex *a, qtri_vertex *b, qtri_vertex *c)
{
    uint32_t index[3];
    qtri_mesh_indices(index, indices, qtri_mesh_has_bytes(draw->mesh));
    light_unlit_vertex(draw, index[0], a);
    light_unlit_vertex(draw, index[1], b);
    light_unlit_vertex(draw, index[2], c);
    if (draw->lights != NULL) {
        draw->lights->model->light_triangle(draw, index);
    }
}

/* qtri_small.light of meshes: lights the vertices, or returns the triangle's intensity, Q15. */
uint32_t qtri_mesh_find_light(const void *from, const void *indices, qtri_vertex *a, qtri_vertex *b,
                              qtri_vertex *c)
{
    const qtri_mesh_job *draw = from;
    if (draw->lit_per_vertex) {
        if (!qtri_vertices_are_lit(a, b, c)) {
            qtri_mesh_light_vertices(draw, indices, a, b, c);
        }
        return QTRI_VERTEX_UNLIT;
    }
    return draw->lit_per_face ? qtri_mesh_light_face(draw, indices) : QTRI_INTENSITY_ONE;
}

/* A large or clipped triangle, lit before it is drawn, while the stack is not deep. */
typedef struct lit_triangle {
    const qtri_mesh_job *draw;
    uint32_t index[3];
    uint32_t intensity_q15[3];
    qtri_rgb color[3]; /* without that intensity; or lit by a view's lights, intensity 1 */
} lit_triangle;

/* Sets intensities, face_q15 where vertices are not lit, and colours as they are without lights. */
static void set_colors(lit_triangle *triangle, qtri_vertex *const vertex[3], uint32_t face_q15)
{
    const qtri_mesh_job *draw = triangle->draw;
    for (int i = 0; i < 3; i++) {
        triangle->intensity_q15[i] = draw->lit_per_vertex ? vertex[i]->intensity_q15 : face_q15;
        triangle->color[i] = *qtri_mesh_color(draw, triangle->index[i]);
    }
}

/* Sets a vertex's texture coordinates, 0 in a mesh without any. */
static void set_uv(int64_t *u_q32, int64_t *v_q32, const qtri_mesh *mesh, uint32_t index)
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

/* A qtri_attribute_source of a lit_triangle: colours and texture coordinates. */
static void set_attributes(const void *from, qtri_screen_vertex out[3])
{
    const lit_triangle *triangle = from;
    const qtri_mesh_job *draw = triangle->draw;
    const bool is_lit = draw->primitive.material->fill == NULL &&
                        qtri_is_lit(&draw->primitive.to.solid.state.options);
    for (int i = 0; i < 3; i++) {
        if (is_lit) {
            out[i].color_8p16[0] = (int32_t)triangle->intensity_q15[i] * 510; /* 255.0 is 1 */
            out[i].color_8p16[1] = out[i].color_8p16[2] = 0;
        } else {
            qtri_line_color_set(out[i].color_8p16, &triangle->color[i], triangle->intensity_q15[i]);
        }
        set_uv(&out[i].u_q32, &out[i].v_q32, draw->mesh, triangle->index[i]);
    }
}

/* ---- Large triangles ---- */

/*
 * Snap residuals of large triangles. Vertices do not keep them, since small triangles, most of a
 * mesh, need none: they are computed again from the mesh's positions. A band of a prepared mesh
 * sets its transforms for that alone.
 */
QTRI_NOINLINE static void set_deferred_transform(const qtri_mesh_job *draw)
{
    qtri_deferred_transform *deferred = draw->deferred;
    qtri_projector_init_view(deferred->projector, deferred->view, deferred->pose,
                             draw->primitive.material->depth_bias, NULL);
    if (draw->positions->begin != NULL) {
        draw->positions->begin(deferred->projector, draw->mesh);
    }
    deferred->is_set = true;
}

QTRI_NOINLINE static void set_rests(qtri_fan_vertex v[3], const qtri_mesh_job *draw,
                                    const uint32_t index[3])
{
    if (draw->deferred != NULL && !draw->deferred->is_set) {
        set_deferred_transform(draw);
    }
    for (int i = 0; i < 3; i++) {
        qtri_clip_vertex clip;
        draw->positions->transform(&draw->primitive.projector, draw->mesh, index[i], &clip);
        qtri_project_rest(v[i].rest, &clip, &v[i].at, v[i].inv_w_q31);
    }
}

/* Whether snap residuals would show: in texels always, in depths where these are steep. */
static bool do_rests_matter(const qtri_draw_state *state, const qtri_point *const p[3],
                            const uint32_t depth_16p16[3], int64_t area)
{
    uint32_t low, high;
    int32_t extent = 0;
    if (state->texture != NULL) {
        return true;
    }
    for (int i = 0; i < 3; i++) {
        const qtri_point *next = p[i == 2 ? 0 : i + 1];
        extent += (int32_t)(qtri_magnitude32(p[i]->x_24p8 - next->x_24p8) +
                            qtri_magnitude32(p[i]->y_24p8 - next->y_24p8));
    }
    qtri_find_range(&low, &high, depth_16p16);
    /* Off by range extent / area at most: by a quarter of a step of 16 bits. */
    return qtri_mul_u32((high - low) >> 14, (uint32_t)extent) > 2 * qtri_magnitude64(area);
}

/* The whole triangle in the form in which clipping leaves one. */
static void set_fan(qtri_fan_vertex v[3], const qtri_mesh_job *draw, const uint32_t index[3],
                    qtri_vertex *const vertex[3], int64_t area)
{
    const qtri_point *const p[3] = {&v[0].at, &v[1].at, &v[2].at};
    uint32_t depth_16p16[3];
    for (int i = 0; i < 3; i++) {
        v[i].at = vertex[i]->at;
        v[i].depth_16p8 = vertex[i]->depth_16p8;
        v[i].inv_w_q31 = vertex[i]->inv_w;
        v[i].b1_q30 = (int32_t)(i == 1) << 30;
        v[i].b2_q30 = (int32_t)(i == 2) << 30;
        v[i].rest[0] = 0;
        v[i].rest[1] = 0;
        depth_16p16[i] = vertex[i]->depth_16p8 & ~0xFFu;
    }
    if (do_rests_matter(&draw->primitive.to.solid.state, p, depth_16p16, area)) {
        set_rests(v, draw, index);
    }
}

/* Lights a triangle and sets its vertices; returns its colour, 0x00RRGGBB. Not inlined: what this
   needs takes no stack while rows are filled. */
QTRI_NOINLINE static uint32_t set_vertices(qtri_large_vertex v[3], const qtri_mesh_job *draw,
                                           const void *indices, qtri_vertex *const vertex[3],
                                           int64_t area)
{
    qtri_draw_state *state = draw->primitive.to.solid.small.state;
    qtri_fan_vertex fan[3];
    const qtri_fan_vertex *const piece[3] = {&fan[0], &fan[1], &fan[2]};
    lit_triangle triangle;
    triangle.draw = draw;
    qtri_mesh_indices(triangle.index, indices, qtri_mesh_has_bytes(draw->mesh));
    set_colors(&triangle, vertex,
               draw->find_large_light != NULL
                   ? draw->find_large_light(draw, indices, vertex[0], vertex[1], vertex[2])
                   : QTRI_INTENSITY_ONE);
    for (int i = 0; i < 3 && state->is_lit && !state->options.per_pixel; i++) {
        triangle.color[i] = qtri_lit_rgb(state->lit[i]);
    }
    for (int i = 0; i < 3; i++) {
        state->alpha_index[i] = triangle.index[i];
    }
    set_fan(fan, draw, triangle.index, vertex, area);
    return qtri_primitive_set_piece(v, &draw->primitive, piece, set_attributes, &triangle);
}

QTRI_NOINLINE void qtri_mesh_draw_large(const qtri_mesh_job *draw, const void *indices,
                                        qtri_vertex *a, qtri_vertex *b, qtri_vertex *c)
{
    const qtri_point *const p[3] = {&a->at, &b->at, &c->at};
    qtri_vertex *const vertex[3] = {a, b, c};
    qtri_draw_state *state = draw->primitive.to.solid.small.state;
    const int64_t area = qtri_triangle_area(p[0], p[1], p[2]);
    if (area != 0 && !qtri_is_beside(state, p)) {
        qtri_large_vertex v[3];
        const uint32_t color = set_vertices(v, draw, indices, vertex, area);
        qtri_large_triangle(state, p, area, color, v);
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

/* ---- Any triangle ---- */

/* Not inlined, so that drawing needs no stack for it. */
QTRI_NOINLINE static void shade_clipped(lit_triangle *triangle, const void *indices,
                                        const qtri_clip_vertex v[3])
{
    uint32_t lit[3];
    triangle->draw->lights->model->shade_clipped(triangle->draw, indices, v, lit);
    for (int i = 0; i < 3; i++) {
        triangle->color[i] = qtri_lit_rgb(lit[i]);
    }
}

/* Sets intensities and colours of a triangle to be clipped, at its vertices v before that. */
static void light_clipped(lit_triangle *triangle, const void *indices, qtri_vertex *const vertex[3],
                          const qtri_clip_vertex v[3])
{
    const qtri_mesh_job *draw = triangle->draw;
    if (draw->lit_per_vertex) {
        qtri_mesh_light_vertices(draw, indices, vertex[0], vertex[1], vertex[2]);
    }
    set_colors(triangle, vertex,
               draw->lit_per_face ? qtri_mesh_light_face(draw, indices) : QTRI_INTENSITY_ONE);
    if (draw->lights != NULL) {
        shade_clipped(triangle, indices, v);
    }
}

/* Draws a triangle that crosses a plane; these are rare, so homogeneous coordinates are not kept
   but computed again. */
QTRI_NOINLINE static void draw_clipped(const qtri_mesh_job *draw, const void *indices,
                                       qtri_vertex *const vertex[3])
{
    if (qtri_mesh_is_outside(vertex)) {
        return;
    }
    qtri_shape shape;
    lit_triangle triangle;
    triangle.draw = draw;
    qtri_mesh_indices(triangle.index, indices, qtri_mesh_has_bytes(draw->mesh));
    for (int i = 0; i < 3; i++) {
        draw->positions->transform(&draw->primitive.projector, draw->mesh, triangle.index[i],
                                   &shape.clip[i]);
        if (draw->primitive.material->fill == NULL) { /* vertices may have alphas */
            draw->primitive.to.solid.small.state->alpha_index[i] = triangle.index[i];
        }
    }
    light_clipped(&triangle, indices, vertex, shape.clip);
    qtri_primitive_triangle(&draw->primitive, &shape, set_attributes, &triangle);
}

/* Fills a triangle whose vertices are all inside. */
QTRI_NOINLINE static void draw_solid(const qtri_mesh_job *draw, const void *indices, qtri_vertex *a,
                                     qtri_vertex *b, qtri_vertex *c)
{
    uint32_t index[3];
    qtri_vertex *const vertex[3] = {a, b, c};
    qtri_small t = draw->primitive.to.solid.small;
    qtri_mesh_indices(index, indices, qtri_mesh_has_bytes(draw->mesh));
    if (!qtri_mesh_draw_small(&t, indices, index, vertex)) {
        qtri_mesh_draw_large(draw, indices, a, b, c);
    }
}

QTRI_NOINLINE void qtri_mesh_draw_visible(const qtri_mesh_job *draw, const void *indices,
                                          qtri_vertex *const vertex[3])
{
    if (!qtri_mesh_is_inside(vertex[0], vertex[1], vertex[2])) {
        draw_clipped(draw, indices, vertex);
    } else if (draw->primitive.material->fill != NULL) {
        draw->primitive.material->fill->triangle(draw, indices, vertex);
    } else {
        draw_solid(draw, indices, vertex[0], vertex[1], vertex[2]);
    }
}

QTRI_NOINLINE bool qtri_mesh_is_culled(const qtri_mesh_job *draw, const qtri_vertex *a,
                                       const qtri_vertex *b, const qtri_vertex *c)
{
    return qtri_mesh_is_inside(a, b, c) &&
           qtri_is_culled(draw->primitive.material->cull,
                          qtri_triangle_area(&a->at, &b->at, &c->at));
}
