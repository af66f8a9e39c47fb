/* SPDX-License-Identifier: MIT */
/*
 * Draw calls of meshes: set up, transform, cull, and draw each triangle.
 */
#include "checked.h"
#include "lights.h"
#include "mesh_faces.h"
#include "qtri/body/pixel.h"
#include "../raster/samples.h"

/* ---- Set-up ---- */

/* Whether the mesh cannot touch the surface: not its rows, for a band. */
static bool is_missed(const qtri_mesh_job *draw, const qtri_surface *surface)
{
    const qtri_box *box = &draw->mesh->bounds;
    if ((box->half.x | box->half.y | box->half.z) == 0 || box->half.x == INT32_MAX) {
        return false; /* unknown, or of wide lines, which reach beyond any box of vertices */
    }
    const qtri_rect bounds = qtri_surface_bounds(surface);
    const int32_t more = draw->primitive.material->fill != NULL; /* lines reach out of their mesh */
    const int32_t low[2] = {bounds.x0 - more, bounds.y0 - more};
    const int32_t high[2] = {bounds.x1 + more, bounds.y1 + more};
    return qtri_projector_misses(&draw->primitive.projector, box, low, high);
}

/* Without vertices every index is past the end; the arrays of what is empty may be NULL. */
static bool is_empty(const qtri_mesh *mesh)
{
    return mesh->vertex_count == 0 || mesh->triangle_count == 0;
}

/* Where pixels take their colours from: the `shade` of qtri_draw_state_init(). */
static int color_source(const qtri_mesh_job *draw)
{
    if (draw->lights != NULL && qtri_by_pixel_of(draw->primitive.material) != NULL) {
        return QTRI_BY_PIXEL;
    }
    if (draw->mesh->colors != NULL || draw->lights != NULL) {
        return qtri_is_smooth(draw->primitive.material) ? QTRI_COLORS : QTRI_TINT;
    }
    if (draw->lit_per_vertex) {
        return QTRI_LIGHT;
    }
    return draw->lit_per_face ? QTRI_TINT : QTRI_FLAT;
}

/* Sets transforms and light; false: nothing can be seen. */
static bool set_transforms(qtri_mesh_job *draw, const qtri_view *view, const qtri_transform *pose)
{
    const qtri_mesh *mesh = draw->mesh;
    qtri_transform object_to_eye;
    if (is_empty(mesh) || draw->positions == NULL) {
        return false;
    }
    qtri_projector_init_view(&draw->primitive.projector, view, pose,
                             draw->primitive.material->depth_bias, &object_to_eye);
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

/* Not inlined, so that its stack is free again. */
QTRI_NOINLINE bool qtri_mesh_job_init(qtri_mesh_job *draw, const qtri_vertex_stage *stage,
                                      const qtri_surface *surface, const qtri_view *view,
                                      const qtri_transform *pose, const qtri_mesh *mesh,
                                      const qtri_material *material, qtri_vertex *vertices,
                                      uint32_t vertex_count)
{
    const bool has_uvs = mesh->uvs != NULL || mesh->uvs16 != NULL;
    draw->primitive.material = material;
    draw->mesh = mesh;
    draw->stage = stage;
    draw->positions = mesh->positions16 != NULL ? stage->positions16 : stage->positions;
    draw->vertices = vertices;
    draw->slot_count = vertex_count;
    draw->lights = qtri_colored_light(view);
    draw->illumination = NULL;
    draw->lit_colors = NULL;
    draw->deferred = NULL;
    draw->front = NULL;
    draw->noted = false;
    const bool normals = mesh->normals != NULL || mesh->normals8 != NULL;
    const bool is_lit = qtri_white_light(view) != NULL;
    draw->lit_per_vertex = is_lit && qtri_is_smooth(material) && normals;
    draw->lit_per_face = is_lit && !draw->lit_per_vertex && stage->face_light != NULL;
    draw->lit_per_vertex = draw->lit_per_vertex && stage->vertex_light != NULL;
    if (draw->lights != NULL) {
        draw->lights->model->begin(draw);
    }
    qtri_primitive_set_target(&draw->primitive, surface, view, material,
                              has_uvs ? material->texture : NULL, color_source(draw));
    if (material->fill != NULL) {
        draw->primitive.to.lines.target.state.table = draw->of.mesh.table;
    } else {
        draw->primitive.to.solid.state.table = draw->of.mesh.table;
        qtri_mesh_solid_init(draw,
                             draw->lit_per_vertex || draw->lit_per_face || mesh->colors != NULL
                                 ? qtri_mesh_find_light
                                 : NULL);
    }
    return pose == NULL || set_transforms(draw, view, pose);
}

/* ---- All triangles ---- */

/* Draws the triangles of a mesh whose vertices are all transformed, each in its slot. */
static void draw_triangles(const qtri_mesh_job *draw)
{
    const bool narrow = qtri_mesh_has_bytes(draw->mesh);
    const uint32_t size = narrow ? 3 : 6;
    const uint8_t *triangle = qtri_mesh_triangle(draw->mesh, 0, narrow);
    const uint8_t *end = triangle + draw->mesh->triangle_count * size;
    for (; triangle != end; triangle += size) {
        uint32_t index[3];
        qtri_vertex *vertex[3];
        if (qtri_mesh_find(index, vertex, draw->vertices, draw->mesh->vertex_count, triangle,
                           narrow) &&
            !qtri_mesh_is_culled(draw, vertex[0], vertex[1], vertex[2])) {
            qtri_mesh_draw_visible(draw, triangle, vertex);
        }
    }
}

/* Fills the front faces of a mesh, back faces being culled and all vertices inside. */
QTRI_NOINLINE static void draw_fronts(const qtri_mesh_job *draw)
{
    qtri_small t = draw->primitive.to.solid.small;
    const bool narrow = qtri_mesh_has_bytes(draw->mesh);
    const uint32_t count = draw->mesh->vertex_count;
    const uint32_t size = narrow ? 3 : 6;
    const uint8_t *triangle = qtri_mesh_triangle(draw->mesh, 0, narrow);
    const uint8_t *end = triangle + draw->mesh->triangle_count * size;
    for (; triangle != end; triangle += size) {
        uint32_t index[3];
        qtri_vertex *vertex[3];
        if (qtri_mesh_find(index, vertex, draw->vertices, count, triangle, narrow)) {
            qtri_mesh_draw_front(draw, &t, triangle, index, vertex);
        }
    }
}

/* Draws a mesh with a slot for every vertex: each is transformed once. */
QTRI_NOINLINE static void draw_whole(const qtri_mesh_job *draw)
{
    const bool inside = qtri_mesh_transform(draw, 0, draw->mesh->vertex_count, draw->vertices);
    if (inside && draw->primitive.material->cull == QTRI_CULL_BACK) {
        draw_fronts(draw);
    } else {
        draw_triangles(draw);
    }
}

/* The vertex's slot, filled: one that is empty holds no index to be read. */
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

void qtri_mesh_draw_range(const qtri_mesh_job *draw, uint32_t first, uint32_t end)
{
    const uint32_t count = draw->mesh->vertex_count;
    const bool narrow = qtri_mesh_has_bytes(draw->mesh);
    for (; first < end; first++) {
        const void *triangle = qtri_mesh_triangle(draw->mesh, first, narrow);
        uint32_t index[3];
        qtri_vertex spare[3];
        qtri_vertex *vertex[3];
        const bool is_found =
            draw->slot_count < count
                ? qtri_mesh_fetch_triangle(draw, triangle, spare, vertex)
                : qtri_mesh_find(index, vertex, draw->vertices, count, triangle, narrow) &&
                      qtri_mesh_are_transformed(vertex);
        if (is_found && !qtri_mesh_is_culled(draw, vertex[0], vertex[1], vertex[2])) {
            qtri_mesh_draw_visible(draw, triangle, vertex);
        }
    }
}

/* Draws a job whose transforms and illumination are set up. */
static void draw_placed(void *with)
{
    qtri_mesh_job *draw = with;
    const qtri_mesh *mesh = draw->mesh;
    const bool has_slots = draw->slot_count >= mesh->vertex_count;
    if (has_slots && draw->primitive.material->fill != NULL) {
        draw->primitive.material->fill->mesh(draw); /* shared edges must not be blended twice */
    } else if (!has_slots) {
        qtri_mesh_clear_slots(draw);
        qtri_mesh_draw_range(draw, 0, mesh->triangle_count);
    } else {
        const qtri_face_culling *culling = mesh->faces.culling;
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
    if (is_empty(mesh) || !qtri_mesh_job_init(&draw, stage, surface, view, pose, mesh, material,
                                              view->vertices, view->vertex_count)) {
        return false;
    }
    draw.front = front;
    if (draw.lights != NULL) {
        draw.lights->model->mesh(&draw, view, pose, true, draw_placed, &draw);
    } else {
        draw_placed(&draw);
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
