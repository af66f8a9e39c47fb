/* SPDX-License-Identifier: MIT */
#include "mesh_faces.h"

#include "lights.h"

static bool find_eye(qtri_eye *eye, const qtri_mesh_job *draw)
{
    const qtri_mesh *mesh = draw->mesh;
    if (mesh->positions16 != NULL) {
        return qtri_eye_find(eye, &draw->primitive.projector, &mesh->faces);
    }
    qtri_projector compact = draw->primitive.projector;
    qtri_projector_compact(&compact, &mesh->origin, mesh->extent);
    return qtri_eye_find(eye, &compact, &mesh->faces);
}

QTRI_NOINLINE static bool begin(qtri_mesh_faces *faces, const qtri_mesh_job *draw)
{
    const qtri_mesh *mesh = draw->mesh;
    const qtri_cull cull = draw->primitive.material->cull;
    if (mesh->faces.planes == NULL || !qtri_culls(cull) || !find_eye(&faces->eye, draw)) {
        return false;
    }
    if (cull == QTRI_CULL_FRONT) {
        qtri_eye_mirror(&faces->eye);
    }
    faces->next = 0;
    faces->inside = true;
    qtri_mesh_clear_slots(draw);
    return true;
}

/* Lists the triangles whose planes may face the eye; returns the end of qtri_mesh_faces.list. */
QTRI_NOINLINE static uint16_t *find_visible(const qtri_eye *from, const qtri_face8 *plane,
                                            const qtri_face8 *end, uint16_t *out)
{
    const qtri_eye eye = *from;
    for (uint32_t entry = 0; plane != end; plane++, entry += QTRI_FACES_STEP) {
        if (!qtri_eye_is_behind(&eye, plane)) {
            *out++ = (uint16_t)entry;
        }
    }
    return out;
}

/* Lists a vertex that is visited first; returns the place of the next entry. */
static inline qtri_vertex *visit(qtri_vertex *vertex, uint32_t index, qtri_vertex *entry)
{
    if (vertex->depth_16p8 == QTRI_VERTEX_EMPTY) {
        vertex->depth_16p8 = 0;
        entry->index = (uint16_t)index;
        entry++;
    }
    return entry;
}

/* Lists vertices that are visited first, and returns their number. Drops triangles with an index
   past the end. */
static inline uint32_t visit_each(qtri_mesh_faces *faces, const qtri_mesh_job *draw, bool narrow)
{
    const uint32_t count = draw->mesh->vertex_count;
    const uint8_t *triangles = faces->triangles;
    const uint16_t *end = faces->end;
    qtri_vertex *vertices = draw->vertices;
    qtri_vertex *entry = vertices;
    uint16_t *kept = faces->list;
    for (const uint16_t *at = faces->list; at != end; at++) {
        uint32_t index[3];
        qtri_vertex *vertex[3];
        const uint8_t *triangle = qtri_mesh_faces_triangle(triangles, *at, narrow);
        if (!qtri_mesh_find(index, vertex, vertices, count, triangle, narrow)) {
            continue;
        }
        *kept++ = *at;
        entry = visit(vertex[0], index[0], entry);
        entry = visit(vertex[1], index[1], entry);
        entry = visit(vertex[2], index[2], entry);
    }
    faces->end = kept;
    return (uint32_t)(entry - vertices);
}

QTRI_NOINLINE static uint32_t visit_all(qtri_mesh_faces *faces, const qtri_mesh_job *draw)
{
    return qtri_mesh_has_bytes(draw->mesh) ? visit_each(faces, draw, true)
                                           : visit_each(faces, draw, false);
}

/* Lights the `count` vertices just listed and transformed. */
static void light(const qtri_mesh_job *draw, uint32_t count)
{
    if (draw->lights != NULL) {
        draw->lights->model->list(draw, count);
    }
    if (!draw->lit_per_vertex) {
        for (uint32_t i = 0; i < count; i++) {
            draw->vertices[draw->vertices[i].index].intensity_q15 = QTRI_INTENSITY_ONE;
        }
    } else {
        draw->stage->vertex_light->list(&draw->of.mesh.lighting, draw->mesh, count, draw->vertices);
    }
}

/* Wireframes note edges there: see mesh_lines.c. */
static void clear_notes(const qtri_mesh_job *draw, uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        draw->vertices[draw->vertices[i].index].inv_w = 0;
    }
}

/* Whether a listed triangle is culled; only planes seen almost edge-on leave that open. */
QTRI_NOINLINE static bool is_culled(const qtri_mesh_job *draw, const uint8_t *triangle)
{
    uint32_t index[3];
    qtri_vertex *v[3];
    qtri_mesh_get(index, v, draw->vertices, triangle, qtri_mesh_has_bytes(draw->mesh));
    return qtri_mesh_is_culled(draw, v[0], v[1], v[2]);
}

/* Sets the bits, for an outline, of triangles first..first + count - 1: of listed front ones. */
QTRI_NOINLINE static void find_front(const qtri_mesh_faces *faces, const qtri_mesh_job *draw,
                                     uint32_t first, uint32_t count)
{
    const bool narrow = qtri_mesh_has_bytes(draw->mesh);
    const qtri_face8 *planes = &draw->mesh->faces.planes[first];
    const qtri_eye eye = faces->eye;
    uint32_t *front = draw->front + first / 32;
    for (uint32_t i = 0; i < count; i += 32) {
        front[i / 32] = 0;
    }
    for (const uint16_t *at = faces->list; at != faces->end; at++) {
        const uint32_t number = qtri_mesh_faces_number(*at);
        if (qtri_eye_is_before(&eye, &planes[number]) ||
            !is_culled(draw, qtri_mesh_faces_triangle(faces->triangles, *at, narrow))) {
            front[number / 32] |= (uint32_t)1 << (number & 31);
        }
    }
}

static bool next(qtri_mesh_faces *faces, const qtri_mesh_job *draw)
{
    const qtri_mesh *mesh = draw->mesh;
    const uint32_t left = mesh->triangle_count - faces->next;
    const uint32_t count = left < QTRI_FACES_AT_ONCE ? left : QTRI_FACES_AT_ONCE;
    const qtri_face8 *plane = &mesh->faces.planes[faces->next];
    if (count == 0) {
        return false;
    }
    faces->triangles = qtri_mesh_triangle(mesh, faces->next, qtri_mesh_has_bytes(mesh));
    faces->end = find_visible(&faces->eye, plane, plane + count, faces->list);
    const uint32_t count_new = visit_all(faces, draw);
    const uint32_t first = faces->next;
    faces->next += count;
    if (count_new != 0) {
        faces->inside &= draw->positions->project(&draw->primitive.projector, mesh, 0, count_new,
                                                  draw->vertices, true);
        light(draw, count_new);
        if (draw->primitive.material->fill != NULL) {
            clear_notes(draw, count_new);
        }
    }
    if (draw->front != NULL) {
        find_front(faces, draw, first, count);
    }
    return true;
}

QTRI_NOINLINE static void draw_listed(const qtri_mesh_faces *faces, const qtri_mesh_job *draw)
{
    const bool narrow = qtri_mesh_has_bytes(draw->mesh);
    for (const uint16_t *at = faces->list; at != faces->end; at++) {
        const uint8_t *triangle = qtri_mesh_faces_triangle(faces->triangles, *at, narrow);
        uint32_t index[3];
        qtri_vertex *vertex[3];
        qtri_mesh_get(index, vertex, draw->vertices, triangle, narrow);
        if (!qtri_mesh_is_culled(draw, vertex[0], vertex[1], vertex[2])) {
            qtri_mesh_draw_visible(draw, triangle, vertex);
        }
    }
}

/* Fills the front faces of a list, back faces being culled and all vertices inside. */
QTRI_NOINLINE static void draw_listed_fronts(const qtri_mesh_faces *faces,
                                             const qtri_mesh_job *draw)
{
    qtri_small t = draw->primitive.to.solid.small;
    const bool narrow = qtri_mesh_has_bytes(draw->mesh);
    const uint8_t *triangles = faces->triangles;
    const uint16_t *end = faces->end;
    qtri_vertex *vertices = draw->vertices;
    for (const uint16_t *at = faces->list; at != end; at++) {
        const uint8_t *triangle = qtri_mesh_faces_triangle(triangles, *at, narrow);
        uint32_t index[3];
        qtri_vertex *vertex[3];
        qtri_mesh_get(index, vertex, vertices, triangle, narrow);
        qtri_mesh_draw_front(draw, &t, triangle, index, vertex);
    }
}

QTRI_NOINLINE static bool draw_all(qtri_mesh_job *draw)
{
    qtri_mesh_faces faces;
    if (!begin(&faces, draw)) {
        return false;
    }
    const bool back_only = draw->primitive.material->cull == QTRI_CULL_BACK;
    qtri_mesh_set_lit(draw);
    while (next(&faces, draw)) {
        if (back_only && faces.inside) {
            draw_listed_fronts(&faces, draw);
        } else {
            draw_listed(&faces, draw);
        }
    }
    return true;
}

const qtri_face_culling qtri_cull_by_planes = {.begin = begin, .next = next, .draw = draw_all};
