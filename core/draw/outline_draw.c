/* SPDX-License-Identifier: MIT */
#include "checked.h"
#include "fill.h"
#include "lights.h"
#include "mesh_faces.h"
#include "outline.h"

/* What one drawing does with triangles that are seen. */
typedef struct drawing {
    const qtri_mesh_job *job;
    uint32_t *front;
    bool draws;
} drawing;

/* Any triangle whose vertices are there. */
QTRI_NOINLINE static void see_any(const drawing *d, const void *triangle, uint32_t number,
                                  qtri_vertex *const vertex[3])
{
    if (qtri_mesh_turned_away(d->job, vertex[0], vertex[1], vertex[2])) {
        return;
    }
    if (qtri_front_is(d->job->material.cull, vertex)) {
        qtri_front_set(d->front, number);
    }
    if (d->draws) {
        qtri_mesh_draw_seen(d->job, triangle, vertex);
    }
}

/* Of a mesh that culls back faces, one with all vertices inside. */
QTRI_INLINE void see_solid(const qtri_mesh_job *job, uint32_t *front, const void *triangle,
                           uint32_t number, qtri_vertex *const vertex[3])
{
    if (!qtri_triangle_is_back(&vertex[0]->at, &vertex[1]->at, &vertex[2]->at)) {
        qtri_front_set(front, number);
        qtri_mesh_draw_solid(job, triangle, vertex[0], vertex[1], vertex[2]);
    }
}

/* All triangles; `simple`: as see_solid(), with indices of 16 bits. */
QTRI_INLINE void see_triangles(const drawing *d, bool narrow, bool simple)
{
    const qtri_mesh_job *job = d->job;
    const qtri_mesh *mesh = job->mesh;
    const uint32_t size = qtri_vertex_size();
    const uint32_t count = mesh->vertex_count;
    qtri_vertex *vertices = job->vertices;
    uint32_t *front = d->front;
    for (uint32_t number = 0; number < mesh->triangle_count; number++) {
        const void *triangle = qtri_mesh_triangle(mesh, number, narrow);
        uint32_t index[3];
        qtri_vertex *vertex[3];
        qtri_mesh_indices(index, triangle, narrow);
        if (!qtri_mesh_find(vertex, vertices, count, index, size)) {
            continue;
        }
        if (simple) {
            see_solid(job, front, triangle, number, vertex);
        } else {
            see_any(d, triangle, number, vertex);
        }
    }
}

QTRI_NOINLINE static void see_whole(const drawing *d)
{
    const qtri_mesh *mesh = d->job->mesh;
    const bool inside = qtri_mesh_transform(d->job, 0, mesh->vertex_count, d->job->vertices);
    const bool narrow = qtri_mesh_has_bytes(mesh);
    if (inside && d->draws && d->job->material.cull == QTRI_CULL_BACK && !narrow) {
        see_triangles(d, false, true);
    } else {
        see_triangles(d, narrow, false);
    }
}

/*
 * All of a list counts as front, for now: a plane leaves few back faces. `front`: of the list's
 * first triangle, in words of which nothing is set. Entries rise.
 */
QTRI_NOINLINE static void set_listed(uint32_t *front, qtri_mesh_faces *faces)
{
    enum { WORD = 32 * QTRI_FACES_STEP };
    uint32_t minus_third = 0 - qtri_mesh_faces_third();
    QTRI_HOLD(minus_third);
    const uint16_t *at = faces->list;
    faces->list[faces->end - at] = UINT16_MAX; /* beyond all words */
    for (uint32_t limit = WORD; at != faces->end; limit += WORD) {
        uint32_t bits = 0;
        uint32_t entry = *at;
        while (entry < limit) {
            bits |= qtri_rotated(1, qtri_mesh_faces_number(entry, minus_third));
            at++;
            QTRI_HOLD(at);
            entry = *at;
        }
        *front++ = bits;
    }
}

/* A function of its own, as few need it. */
QTRI_NOINLINE static void unset_listed(uint32_t *front, const qtri_mesh_faces *faces,
                                       const uint8_t *triangle)
{
    const uint32_t entry = (uint32_t)(triangle - faces->triangles);
    qtri_front_unset(front, qtri_mesh_faces_number(entry, qtri_mesh_faces_third()));
}

/* A list of triangles of a mesh that culls its back faces, all vertices being inside. */
QTRI_NOINLINE static void see_fronts(const qtri_mesh_job *job, qtri_mesh_faces *faces,
                                     uint32_t *front)
{
    const uint32_t size = qtri_vertex_size();
    const uint8_t *triangles = faces->triangles;
    const uint16_t *end = faces->end;
    qtri_vertex *vertices = job->vertices;
    set_listed(front, faces);
    for (const uint16_t *at = faces->list; at != end; at++) {
        const uint8_t *triangle = qtri_mesh_faces_triangle(triangles, *at, false);
        uint32_t index[3];
        qtri_vertex *vertex[3];
        qtri_mesh_indices(index, triangle, false);
        qtri_mesh_get(vertex, vertices, index, size);
        if (qtri_triangle_is_back(&vertex[0]->at, &vertex[1]->at, &vertex[2]->at)) {
            unset_listed(front, faces, triangle);
        } else {
            qtri_mesh_draw_solid(job, triangle, vertex[0], vertex[1], vertex[2]);
        }
    }
}

/* Any list of triangles, the first of which is `first` of the mesh. */
static void see_list(const drawing *d, const qtri_mesh_faces *faces, uint32_t first)
{
    const bool narrow = qtri_mesh_has_bytes(d->job->mesh);
    const uint32_t third = qtri_mesh_faces_third();
    for (const uint16_t *at = faces->list; at != faces->end; at++) {
        const uint8_t *triangle = qtri_mesh_faces_triangle(faces->triangles, *at, narrow);
        uint32_t index[3];
        qtri_vertex *vertex[3];
        qtri_mesh_indices(index, triangle, narrow);
        qtri_mesh_get(vertex, d->job->vertices, index, qtri_vertex_size());
        see_any(d, triangle, first + qtri_mesh_faces_number(*at, third), vertex);
    }
}

QTRI_NOINLINE static bool see_faces(const drawing *d, qtri_mesh_job *job)
{
    const qtri_face_culling *culling = qtri_mesh_face_culling(job->mesh);
    const bool narrow = qtri_mesh_has_bytes(job->mesh);
    const bool simple = d->draws && job->material.cull == QTRI_CULL_BACK && !narrow;
    qtri_mesh_faces faces;
    if (culling == NULL || !culling->begin(&faces, job)) {
        return false;
    }
    job->lit = true;
    for (uint32_t first = 0; culling->next(&faces, job); first = faces.next) {
        if (simple && faces.inside) {
            see_fronts(job, &faces, d->front + first / 32);
        } else {
            see_list(d, &faces, first);
        }
    }
    return true;
}

/* A function of its own, so that its stack is free again. */
QTRI_NOINLINE static bool begin(qtri_mesh_job *job, const qtri_surface *surface,
                                const qtri_view *view, const qtri_transform *pose,
                                const qtri_mesh *mesh, const qtri_material *material)
{
    qtri_mesh_job_init(job, &qtri_vertex_stage_any, surface, view, mesh, material, view->vertices,
                       view->vertex_count);
    return qtri_mesh_job_place(job, view, pose);
}

/* Once it is placed, and lit by a view's lights. */
static void see_placed(qtri_mesh_job *job, void *with)
{
    const drawing *d = with;
    if (!see_faces(d, job)) {
        see_whole(d);
    }
}

/* For a solid mesh with a vertex for each of its vertices. */
QTRI_NOINLINE static void see(const qtri_surface *surface, const qtri_view *view,
                              const qtri_transform *pose, const qtri_material *material,
                              qtri_outline *outline, bool draws)
{
    qtri_mesh_job job;
    drawing d = {&job, outline->front, draws};
    if (!begin(&job, surface, view, pose, outline->mesh, material)) {
        return;
    }
    qtri_front_clear(outline->front, outline->mesh->triangle_count);
    if (draws && view->lights != NULL) {
        view->lights->model->mesh(&job, view, pose, true, see_placed, &d);
    } else {
        see_placed(&job, &d);
    }
    qtri_outline_set(outline, view->vertices, view, pose, material, surface->width,
                     surface->height);
}

static enum qtri_error see_or_draw(const qtri_surface *surface, const qtri_view *view,
                                   const qtri_transform *pose, const qtri_material *material,
                                   qtri_outline *outline, bool draws)
{
    QTRI_ASSERT(outline != NULL);
    qtri_outline_clear(outline);
    if (outline->mesh == NULL) {
        return QTRI_ERROR_MEMORY;
    }
    const bool complete = view->vertex_count >= outline->mesh->vertex_count;
    if (complete && material->fill == NULL) {
        see(surface, view, pose, material, outline, draws);
        return QTRI_OK;
    }
    if (draws) {
        qtri_draw_mesh(surface, view, pose, outline->mesh, material);
    }
    return complete ? QTRI_OK : QTRI_ERROR_MEMORY;
}

enum qtri_error qtri_draw_mesh_outlined(const qtri_surface *surface, const qtri_view *view,
                                        const qtri_transform *pose, const qtri_material *material,
                                        qtri_outline *outline)
{
    return see_or_draw(surface, view, pose, material, outline, true);
}

enum qtri_error qtri_find_outline(const qtri_surface *surface, const qtri_view *view,
                                  const qtri_transform *pose, const qtri_material *material,
                                  qtri_outline *outline)
{
    return see_or_draw(surface, view, pose, material, outline, false);
}
