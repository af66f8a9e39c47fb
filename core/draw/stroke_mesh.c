/* SPDX-License-Identifier: MIT */
/*
 * Wireframes of strokes. Edges are found, lit and shared out as those of &qtri_wireframe are; only
 * what draws an edge is another.
 */
#include "../raster/stroke_line.h"
#include "fill.h"
#include "lights.h"
#include "stroke_job.h"

/* A line job whose lines are strokes: `mesh` is first, and the line job in it tells where. */
typedef struct wide_job {
    qtri_mesh_job mesh;
    qtri_stroker stroker;
    qtri_stroke_place place;
} wide_job;

/* See qtri_line_draws. */
static void draw_edge(const qtri_line_job *job, const qtri_vertex *a, const qtri_vertex *b,
                      const qtri_line_color *color)
{
    wide_job *wide = job->wide;
    wide->place.end[0] = a->at;
    wide->place.end[1] = b->at;
    qtri_line_look(&wide->stroker.look, job, a, b, color);
    qtri_stroker_draw_part(&wide->stroker, &wide->place);
}

/* As qtri_draw_mesh does it with fewer slots than vertices. */
QTRI_NOINLINE static void draw_by_slots(const qtri_mesh_job *draw)
{
    const qtri_mesh *mesh = draw->mesh;
    qtri_mesh_clear_slots(draw);
    for (uint32_t i = 0; i < mesh->triangle_count; i++) {
        const void *triangle = qtri_mesh_triangle(mesh, i, qtri_mesh_has_bytes(mesh));
        qtri_vertex spare[3];
        qtri_vertex *vertex[3];
        if (qtri_mesh_fetch_triangle(draw, triangle, spare, vertex) &&
            !qtri_mesh_turned_away(draw, vertex[0], vertex[1], vertex[2])) {
            qtri_mesh_draw_seen(draw, triangle, vertex);
        }
    }
}

/* Once it is placed, and lit by a view's lights. */
static void draw_placed(qtri_mesh_job *draw, void *with)
{
    (void)with;
    if (draw->slot_count < draw->mesh->vertex_count) {
        draw_by_slots(draw);
    } else {
        qtri_wireframe.mesh(draw);
    }
}

/*
 * The rows in which the line job looks for triangles reach as far beyond the surface's as an edge
 * does beyond its vertices: a radius, and the corner of a square end a radius times sqrt(2).
 */
static void widen_rows(qtri_line_job *job, int32_t radius)
{
    const int32_t reach = radius + radius / 2 + 1;
    job->top_24p8 -= reach;
    job->height_24p8 += 2 * (uint32_t)reach;
}

/* Whether edges are lines that need no union of parts: no wider than two pixels, with flat ends. */
static bool is_thin(const qtri_stroke *stroke, const qtri_stroke_place *place)
{
    return stroke->edges != NULL && place->radius_24p8 <= QTRI_STROKE_LINE_RADIUS &&
           place->caps[0] != QTRI_CAP_ROUND;
}

void qtri_draw_wide_wireframe(const qtri_surface *surface, const qtri_view *view,
                              const qtri_transform *pose, const qtri_mesh *mesh,
                              const qtri_stroke *stroke, const qtri_material *material)
{
    QTRI_CHECK(qtri_check_surface(surface));
    QTRI_CHECK(qtri_check_material(material));
    QTRI_CHECK(qtri_check_view(view, pose));
    QTRI_CHECK(qtri_check_stroke(stroke));
    QTRI_CHECK(qtri_check_mesh(mesh));
    wide_job wide;
    qtri_material wired = *material;
    wired.fill = &qtri_wireframe;
    wide.place.radius_24p8 = qtri_stroke_radius(stroke->width);
    if (wide.place.radius_24p8 == 0 ||
        !qtri_stroker_init(&wide.stroker, surface, material, stroke)) {
        return;
    }
    wide.place.caps[0] = qtri_stroke_cap(stroke);
    wide.place.caps[1] = wide.place.caps[0];
    /* Lines reach beyond their mesh: no box says that none can be seen. */
    const qtri_box everywhere = {{0, 0, 0}, {INT32_MAX, INT32_MAX, INT32_MAX}};
    qtri_mesh unbounded = *mesh;
    unbounded.bounds = everywhere;
    qtri_mesh_job_init(&wide.mesh, &qtri_vertex_stage_any, surface, view, &unbounded, &wired,
                       view->vertices, view->vertex_count);
    qtri_line_job *job = &wide.mesh.primitive.to.lines.job;
    const qtri_stroke_line thin = {wide.place.radius_24p8, wide.place.caps[0] == QTRI_CAP_SQUARE,
                                   stroke->alpha};
    if (is_thin(stroke, &wide.place)) {
        qtri_stroke_line_choose(job, surface, material, &thin, stroke->edges->line);
    } else {
        job->draw = draw_edge;
        job->wide = &wide;
        widen_rows(job, wide.place.radius_24p8);
    }
    if (!qtri_mesh_job_place(&wide.mesh, view, pose)) {
        return;
    }
    if (view->lights != NULL) {
        view->lights->model->mesh(&wide.mesh, view, pose, true, draw_placed, NULL);
    } else {
        draw_placed(&wide.mesh, NULL);
    }
}
