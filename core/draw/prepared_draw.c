/* SPDX-License-Identifier: MIT */
#include "checked.h"
#include "fill.h"
#include "lights.h"
#include "prepared_lists.h"

/*
 * Its vertices, if all are there; false when an index is past the end, or a vertex was not met:
 * then the triangle's plane turned away.
 */
static bool find_triangle(const qtri_mesh_job *job, const void *triangle, qtri_vertex *vertex[3])
{
    const uint32_t count = job->mesh->vertex_count;
    uint32_t index[3];
    qtri_mesh_indices(index, triangle, qtri_mesh_has_bytes(job->mesh));
    return qtri_mesh_find(vertex, job->vertices, count, index, qtri_vertex_size()) &&
           vertex[0]->depth_16p8 != QTRI_VERTEX_EMPTY &&
           vertex[1]->depth_16p8 != QTRI_VERTEX_EMPTY && vertex[2]->depth_16p8 != QTRI_VERTEX_EMPTY;
}

/* Triangles first..end - 1, whatever they are. */
static void draw_range(const qtri_mesh_job *job, const qtri_prepared *prepared, uint32_t first,
                       uint32_t end)
{
    const qtri_mesh *mesh = job->mesh;
    const bool complete = qtri_prepared_is_complete(prepared);
    for (; first < end; first++) {
        const uint8_t *triangle = qtri_prepared_triangle(mesh, first);
        qtri_vertex spare[3];
        qtri_vertex *vertex[3];
        if (!(complete ? find_triangle(job, triangle, vertex)
                       : qtri_mesh_fetch_triangle(job, triangle, spare, vertex))) {
            continue;
        }
        if (complete && prepared->back_only
                ? !qtri_triangle_is_back(&vertex[0]->at, &vertex[1]->at, &vertex[2]->at)
                : !qtri_mesh_turned_away(job, vertex[0], vertex[1], vertex[2])) {
            qtri_mesh_draw_seen(job, triangle, vertex);
        }
    }
}

/* Triangles of a complete mesh that are listed one by one: all of them are seen. */
static inline void draw_seen(const qtri_mesh_job *job, const uint16_t *lists, uint32_t place,
                             uint32_t end, const void *triangles, bool narrow)
{
    while (place != end) {
        const uint8_t *triangle = triangles;
        triangle += qtri_list_next(lists, &place) * (narrow ? 3 : 6);
        uint32_t index[3];
        qtri_mesh_indices(index, triangle, narrow);
        qtri_vertex *const vertex[3] = {&job->vertices[index[0]], &job->vertices[index[1]],
                                        &job->vertices[index[2]]};
        qtri_mesh_draw_seen(job, triangle, vertex);
    }
}

QTRI_NOINLINE static void draw_list(const qtri_mesh_job *job, const qtri_prepared *prepared,
                                    uint32_t band)
{
    const qtri_mesh *mesh = prepared->mesh;
    const uint16_t *lists = prepared->lists;
    const uint32_t log2 = prepared->group_log2;
    uint32_t place = lists[2 * band];
    const uint32_t end = lists[2 * band + 1];
    if (place == 0) {
        return;
    }
    if (log2 == 0 && qtri_prepared_is_complete(prepared)) {
        if (prepared->back_only && job->material.fill == NULL) {
            qtri_mesh_draw_band(job, lists, place, end);
        } else if (qtri_mesh_has_bytes(mesh)) {
            draw_seen(job, lists, place, end, mesh->triangles8, true);
        } else {
            draw_seen(job, lists, place, end, mesh->triangles, false);
        }
        return;
    }
    while (place != end) {
        const uint32_t first = qtri_list_next(lists, &place) << log2;
        const uint32_t size = mesh->triangle_count - first < (uint32_t)1 << log2
                                  ? mesh->triangle_count - first
                                  : (uint32_t)1 << log2;
        draw_range(job, prepared, first, first + size);
    }
}

/* The band that a surface is: its list, and triangles that are in none. */
typedef struct band_work {
    const qtri_prepared *prepared;
    bool by_list;
    uint32_t band, first, count;
} band_work;

static void draw_band(qtri_mesh_job *job, void *with)
{
    const band_work *work = with;
    if (work->by_list) {
        draw_list(job, work->prepared, work->band);
    }
    draw_range(job, work->prepared, work->first, work->count);
}

void qtri_draw_prepared(const qtri_surface *surface, const qtri_prepared *prepared)
{
    QTRI_CHECK(qtri_check_surface(surface));
    QTRI_CHECK(qtri_check_prepared(prepared));
    const qtri_rect bounds = qtri_surface_bounds(surface);
    if (prepared->mesh == NULL || !prepared->is_seen || qtri_rect_is_empty(&bounds) ||
        surface->width != prepared->width || surface->height != prepared->height) {
        return;
    }
    /* Rows of one band of the frame, and its halo, have a list; others look at all triangles. */
    const uint32_t count = prepared->mesh->triangle_count;
    const int32_t number = (bounds.y0 + prepared->halo) / prepared->rows;
    const uint32_t band = (uint32_t)number;
    const bool by_list = prepared->listed > 0 && number * prepared->rows < prepared->height &&
                         bounds.y1 <= (number + 1) * prepared->rows + prepared->halo;
    const uint32_t first = by_list ? prepared->listed : 0;
    qtri_mesh_job job;
    if ((first >= count && prepared->lists[2 * band] == 0) ||
        !qtri_prepared_begin(&job, prepared, surface, prepared->is_placed)) {
        return;
    }
    qtri_late_place late = {&job.primitive, prepared->view, prepared->pose, false};
    job.late = prepared->is_placed ? NULL : &late;
    job.lit = qtri_prepared_is_complete(prepared);
    if (!job.lit) {
        qtri_mesh_clear_slots(&job);
    }
    if (job.material.fill != NULL) {
        job.material.fill->band(&job);
    }
    band_work work = {prepared, by_list, band, first, count};
    if (job.lights != NULL && prepared->is_placed) {
        job.lights->model->mesh(&job, prepared->view, prepared->pose, false, draw_band, &work);
    } else {
        draw_band(&job, &work);
    }
}
