/* SPDX-License-Identifier: MIT */
#include "checked.h"
#include "fill.h"
#include "lights.h"
#include "mesh_faces.h"

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
QTRI_NOINLINE static bool begin(qtri_mesh_job *draw, const qtri_surface *surface,
                                const qtri_view *view, const qtri_transform *pose,
                                const qtri_mesh *mesh, const qtri_material *material)
{
    qtri_mesh_job_init(draw, surface, view, mesh, material, view->vertices, view->vertex_count);
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

void qtri_draw_mesh(const qtri_surface *surface, const qtri_view *view, const qtri_transform *pose,
                    const qtri_mesh *mesh, const qtri_material *material)
{
    QTRI_CHECK(qtri_check_surface(surface));
    QTRI_CHECK(qtri_check_material(material));
    QTRI_CHECK(qtri_check_view(view, pose));
    QTRI_CHECK(qtri_check_mesh(mesh));
    qtri_mesh_job draw;
    if (!begin(&draw, surface, view, pose, mesh, material)) {
        return;
    }
    if (view->lights != NULL) {
        view->lights->model->mesh(&draw, view, pose, true, draw_placed, NULL);
    } else {
        draw_placed(&draw, NULL);
    }
}
