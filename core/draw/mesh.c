/* SPDX-License-Identifier: MIT */
/*
 * Draw calls of meshes: set up, transform, light, cull, and hand each triangle to the rasterizer,
 * to the clipper, or to the material's fill.
 */
#include "checked.h"
#include "fill.h"
#include "lights.h"
#include "mesh_faces.h"
#include "per_pixel.h"
#include "qtri/body/pixel.h"
#include "../raster/samples.h"

/* ---- Light ---- */

/* Which triangle of the mesh it is: 0xAAAAAAAB times 3 is 1 modulo 2^32. */
static uint32_t number_of(const qtri_mesh *mesh, const void *indices)
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
                                         number_of(draw->mesh, indices), index);
}

static inline void light_corner(const qtri_mesh_job *draw, const void *indices, int corner,
                                qtri_vertex *vertex)
{
    if (vertex->intensity_q15 != QTRI_VERTEX_UNLIT) {
        return;
    }
    vertex->intensity_q15 = QTRI_INTENSITY_ONE;
    if (draw->lit_per_vertex) {
        vertex->intensity_q15 = (uint16_t)draw->stage->vertex_light->vertex(
            &draw->of.mesh.lighting, draw->mesh, qtri_mesh_index(draw->mesh, indices, corner));
    }
}

QTRI_NOINLINE void qtri_mesh_light_corners(const qtri_mesh_job *draw, const void *indices,
                                           qtri_vertex *a, qtri_vertex *b, qtri_vertex *c)
{
    light_corner(draw, indices, 0, a);
    light_corner(draw, indices, 1, b);
    light_corner(draw, indices, 2, c);
    if (draw->lights != NULL) {
        draw->lights->model->meet(draw, indices);
    }
}

/* Lights a triangle's vertices, or the triangle: qtri_small.light of meshes. */
static uint32_t find_light(const void *from, const void *indices, qtri_vertex *a, qtri_vertex *b,
                           qtri_vertex *c)
{
    const qtri_mesh_job *draw = from;
    if (draw->lit_per_vertex) {
        if (!draw->lit && !qtri_vertices_are_lit(a, b, c)) {
            qtri_mesh_light_corners(draw, indices, a, b, c);
        }
        return QTRI_VERTEX_UNLIT;
    }
    return draw->lit_per_face ? qtri_mesh_light_face(draw, indices) : QTRI_INTENSITY_ONE;
}

/* ---- Set-up ---- */

/* Vertices from which on a look at eight corners pays. */
enum { WORTH_A_BOX = 64 };

/* Whether the mesh cannot touch the surface: not its rows, for a band. */
static bool is_missed(const qtri_mesh_job *draw, const qtri_surface *surface)
{
    const qtri_mesh *mesh = draw->mesh;
    qtri_box box = mesh->bounds;
    if ((box.half.x | box.half.y | box.half.z) == 0) {
        if (mesh->positions16 == NULL || mesh->vertex_count < WORTH_A_BOX) {
            return false;
        }
        box.center = mesh->origin; /* the cube that 16 bits span */
        box.half.x = mesh->extent;
        box.half.y = mesh->extent;
        box.half.z = mesh->extent;
    }
    if (box.half.x == INT32_MAX) {
        return false; /* of wide lines, whose reach does not count in any space */
    }
    const qtri_rect bounds = qtri_surface_bounds(surface);
    /* Smooth lines reach out of their mesh, and samples lie beside the centres of pixels. */
    const int32_t more = draw->material.fill != NULL || qtri_sampling_of(surface->format) != NULL;
    const int32_t low[2] = {bounds.x0 - more, bounds.y0 - more};
    const int32_t high[2] = {bounds.x1 + more, bounds.y1 + more};
    return qtri_projector_misses(&draw->primitive.projector, &box, low, high);
}

/* Without vertices every index is past the end; the arrays of what is empty may be NULL. */
static bool is_empty(const qtri_mesh *mesh)
{
    return mesh->vertex_count == 0 || mesh->triangle_count == 0;
}

/* What colours do, see qtri_draw_state_init(). */
static int shade_of(const qtri_mesh_job *draw)
{
    if (draw->lights != NULL && qtri_by_pixel_of(&draw->material) != NULL) {
        return QTRI_BY_PIXEL;
    }
    if (draw->mesh->colors != NULL || draw->lights != NULL) {
        return qtri_is_smooth(&draw->material) ? QTRI_COLORS : QTRI_TINT;
    }
    if (draw->lit_per_vertex) {
        return QTRI_LIGHT;
    }
    return draw->lit_per_face ? QTRI_TINT : QTRI_FLAT;
}

void qtri_mesh_job_init(qtri_mesh_job *draw, const qtri_vertex_stage *stage,
                        const qtri_surface *surface, const qtri_view *view, const qtri_mesh *mesh,
                        const qtri_material *material, qtri_vertex *vertices, uint32_t vertex_count)
{
    draw->material = *material;
    if (mesh->uvs == NULL && mesh->uvs16 == NULL) {
        draw->material.texture = NULL;
    }
    draw->mesh = mesh;
    draw->stage = stage;
    draw->positions = mesh->positions16 != NULL ? stage->positions16 : stage->positions;
    draw->vertices = vertices;
    draw->slot_count = vertex_count;
    draw->lights = view->lights;
    draw->illumination = NULL;
    draw->lit_colors = NULL;
    draw->late = NULL;
    draw->front = NULL;
    draw->noted = false;
    draw->lit = false;
    const bool normals = mesh->normals != NULL || mesh->normals8 != NULL;
    const bool is_lit = view->light != NULL && view->lights == NULL;
    draw->lit_per_vertex = is_lit && qtri_is_smooth(material) && normals;
    draw->lit_per_face = is_lit && !draw->lit_per_vertex && stage->face_light != NULL;
    draw->lit_per_vertex = draw->lit_per_vertex && stage->vertex_light != NULL;
    if (draw->lights != NULL) {
        draw->lights->model->begin(draw);
    }
    qtri_primitive_set_target(&draw->primitive, surface, view, &draw->material, shade_of(draw));
    if (material->fill != NULL) {
        draw->primitive.to.lines.target.state.table = draw->of.mesh.table;
    } else {
        draw->primitive.to.solid.state.table = draw->of.mesh.table;
        qtri_mesh_solid_init(
            draw,
            draw->lit_per_vertex || draw->lit_per_face || mesh->colors != NULL ? find_light : NULL);
    }
}

bool qtri_mesh_job_place(qtri_mesh_job *draw, const qtri_view *view, const qtri_transform *pose)
{
    const qtri_mesh *mesh = draw->mesh;
    qtri_transform object_to_eye;
    if (is_empty(mesh) || draw->positions == NULL) {
        return false;
    }
    qtri_transform_mul(&object_to_eye, &view->camera, pose);
    qtri_primitive_place_in_eye(&draw->primitive, view, &object_to_eye);
    if (is_missed(draw, draw->primitive.surface)) {
        return false;
    }
    if (draw->positions->begin != NULL) {
        draw->positions->begin(&draw->primitive.projector, mesh);
    }
    if (draw->lit_per_vertex || draw->lit_per_face) {
        const qtri_vertex_stage *stage = draw->stage;
        (draw->lit_per_vertex ? stage->vertex_light->init : stage->face_light->init)(
            &draw->of.mesh.lighting, view->light, &object_to_eye,
            draw->lit_per_vertex && mesh->normals8 != NULL, stage->uneven_light);
    }
    return true;
}

/* ---- One triangle whose vertices are transformed ---- */

/* What light makes of the corners' colours. */
static void light_triangle(uint32_t intensity_q15[3], const qtri_mesh_job *draw,
                           const void *triangle, qtri_vertex *const vertex[3])
{
    uint32_t face_q15 =
        draw->lit_per_face ? qtri_mesh_light_face(draw, triangle) : QTRI_INTENSITY_ONE;
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
    for (int i = 0; i < 3; i++) {
        draw->positions->transform(&draw->primitive.projector, draw->mesh,
                                   qtri_mesh_index(draw->mesh, indices, i), &shape.clip[i]);
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

/* ---- All triangles ---- */

/* The triangles of a mesh whose vertices are all there. */
static inline void draw_triangles(const qtri_mesh_job *draw, const void *triangles, bool narrow)
{
    const uint32_t size = narrow ? 3 : 6;
    const uint8_t *triangle = triangles;
    const uint8_t *end = triangle + draw->mesh->triangle_count * size;
    for (; triangle != end; triangle += size) {
        uint32_t index[3];
        qtri_vertex *vertex[3];
        qtri_mesh_indices(index, triangle, narrow);
        if (qtri_mesh_find(vertex, draw->vertices, draw->mesh->vertex_count, index,
                           qtri_vertex_size()) &&
            !qtri_mesh_turned_away(draw, vertex[0], vertex[1], vertex[2])) {
            qtri_mesh_draw_seen(draw, triangle, vertex);
        }
    }
}

/* A slot for every vertex: each is transformed once. */
QTRI_NOINLINE static void draw_whole(const qtri_mesh_job *draw)
{
    const qtri_mesh *mesh = draw->mesh;
    const bool inside = qtri_mesh_transform(draw, 0, mesh->vertex_count, draw->vertices);
    if (inside && draw->material.cull == QTRI_CULL_BACK) {
        qtri_mesh_draw_whole(draw);
    } else if (qtri_mesh_has_bytes(mesh)) {
        draw_triangles(draw, mesh->triangles8, true);
    } else {
        draw_triangles(draw, mesh->triangles, false);
    }
}

/*
 * The vertex's slot, filled: one that is empty holds no index to be read. Vertex i lives in slot i
 * modulo their number; when another corner of the same triangle holds it, or there is none, `spare`
 * serves.
 */
static qtri_vertex *fetch(const qtri_mesh_job *draw, uint32_t index, qtri_vertex *spare,
                          qtri_vertex *const taken[2])
{
    qtri_vertex *slot = spare;
    if (draw->slot_count > 0) {
        qtri_vertex *own = &draw->vertices[index % draw->slot_count];
        if (own->depth_16p8 != QTRI_VERTEX_EMPTY && own->index == index) {
            return own;
        }
        slot = own == taken[0] || own == taken[1] ? spare : own;
    }
    (void)qtri_mesh_transform(draw, index, 1, slot);
    slot->index = (uint16_t)index;
    return slot;
}

bool qtri_mesh_fetch_triangle(const qtri_mesh_job *draw, const void *triangle, qtri_vertex spare[3],
                              qtri_vertex *vertex[3])
{
    const qtri_mesh *mesh = draw->mesh;
    const uint32_t count = mesh->vertex_count;
    uint32_t index[3];
    qtri_mesh_indices(index, triangle, qtri_mesh_has_bytes(mesh));
    if (index[0] >= count || index[1] >= count || index[2] >= count) {
        return false;
    }
    vertex[0] = NULL;
    vertex[1] = NULL;
    for (int corner = 0; corner < 3; corner++) {
        vertex[corner] = fetch(draw, index[corner], &spare[corner], vertex);
    }
    return true;
}

void qtri_mesh_clear_slots(const qtri_mesh_job *draw)
{
    for (uint32_t i = 0; i < draw->slot_count; i++) {
        draw->vertices[i].depth_16p8 = QTRI_VERTEX_EMPTY;
    }
}

/* Fewer slots than vertices: some are transformed again. */
QTRI_NOINLINE static void draw_by_slots(const qtri_mesh_job *draw)
{
    const qtri_mesh *mesh = draw->mesh;
    qtri_mesh_clear_slots(draw);
    for (uint32_t i = 0; i < mesh->triangle_count; i++) {
        const void *triangle = qtri_mesh_has_bytes(mesh) ? (const void *)mesh->triangles8[i]
                                                         : (const void *)mesh->triangles[i];
        qtri_vertex spare[3];
        qtri_vertex *vertex[3];
        if (qtri_mesh_fetch_triangle(draw, triangle, spare, vertex) &&
            !qtri_mesh_turned_away(draw, vertex[0], vertex[1], vertex[2])) {
            qtri_mesh_draw_seen(draw, triangle, vertex);
        }
    }
}

/* A function of its own, so that its stack is free again. */
QTRI_NOINLINE static bool begin(qtri_mesh_job *draw, const qtri_vertex_stage *stage,
                                const qtri_surface *surface, const qtri_view *view,
                                const qtri_transform *pose, const qtri_mesh *mesh,
                                const qtri_material *material)
{
    qtri_mesh_job_init(draw, stage, surface, view, mesh, material, view->vertices,
                       view->vertex_count);
    return qtri_mesh_job_place(draw, view, pose);
}

/* Once it is placed, and lit by a view's lights. */
static void draw_placed(qtri_mesh_job *draw, void *with)
{
    const qtri_mesh *mesh = draw->mesh;
    (void)with;
    const bool has_slots = draw->slot_count >= mesh->vertex_count;
    if (has_slots && draw->material.fill != NULL) {
        draw->material.fill->mesh(draw); /* shared edges must not be blended twice */
    } else if (!has_slots) {
        draw_by_slots(draw);
    } else {
        const qtri_face_culling *culling = qtri_mesh_face_culling(mesh);
        if (culling == NULL || !culling->draw(draw)) {
            draw_whole(draw);
        }
    }
}

bool qtri_mesh_draw(const qtri_vertex_stage *stage, const qtri_surface *surface,
                    const qtri_view *view, const qtri_transform *pose, const qtri_mesh *mesh,
                    const qtri_material *material, uint32_t *front)
{
    QTRI_ASSERT(stage != NULL);
    QTRI_CHECK(qtri_check_surface(surface));
    QTRI_CHECK(qtri_check_material(material));
    QTRI_CHECK(qtri_check_view(view, pose));
    QTRI_CHECK(qtri_check_mesh(mesh));
    qtri_mesh_job draw;
    if (is_empty(mesh) || !begin(&draw, stage, surface, view, pose, mesh, material)) {
        return false;
    }
    draw.front = front;
    if (view->lights != NULL) {
        view->lights->model->mesh(&draw, view, pose, true, draw_placed, NULL);
    } else {
        draw_placed(&draw, NULL);
    }
    return true;
}

void qtri_draw_mesh_by(const qtri_vertex_stage *stage, const qtri_surface *surface,
                       const qtri_view *view, const qtri_transform *pose, const qtri_mesh *mesh,
                       const qtri_material *material)
{
    (void)qtri_mesh_draw(stage, surface, view, pose, mesh, material, NULL);
}

const qtri_vertex_stage qtri_vertex_stage_any = {.positions = &qtri_positions_wide,
                                                 .positions16 = &qtri_positions_compact,
                                                 .vertex_light = &qtri_light_by_vertex,
                                                 .face_light = &qtri_light_by_face,
                                                 .uneven_light = &qtri_light_uneven};

void qtri_draw_mesh(const qtri_surface *surface, const qtri_view *view, const qtri_transform *pose,
                    const qtri_mesh *mesh, const qtri_material *material)
{
    qtri_draw_mesh_by(&qtri_vertex_stage_any, surface, view, pose, mesh, material);
}
