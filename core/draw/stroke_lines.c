/* SPDX-License-Identifier: MIT */
#include "stroke_job.h"

void qtri_draw_polyline(const qtri_surface *surface, const qtri_view *view,
                        const qtri_transform *pose, const qtri_corner *corners,
                        uint32_t corner_count, const qtri_stroke *stroke,
                        const qtri_material *material)
{
    QTRI_CHECK(qtri_check_surface(surface));
    QTRI_CHECK(qtri_check_material(material));
    QTRI_CHECK(qtri_check_view(view, pose));
    QTRI_CHECK(qtri_check_stroke(stroke));
    QTRI_CHECK(qtri_check_corners(corners, corner_count, 1));
    qtri_stroke_job job;
    qtri_stroker stroker;
    if (corner_count == 0 || !qtri_stroker_init(&stroker, surface, material, stroke)) {
        return;
    }
    qtri_stroke_job_init(&job, view, pose, corners, corner_count, stroke, material);
    if (job.radius == 0) {
        return;
    }
    const uint32_t kept = view->vertices == NULL              ? 0
                          : view->vertex_count < corner_count ? view->vertex_count
                                                              : corner_count;
    for (uint32_t i = 0; i < kept; i++) {
        qtri_stroke_job_vertex(&job, i, &view->vertices[i]);
    }
    job.vertices = view->vertices;
    job.kept = kept;
    const bool is_loop = job.closed || corner_count == 1;
    const qtri_stroke_source source = {&job, is_loop ? corner_count : corner_count - 1,
                                       qtri_stroke_job_place, qtri_stroke_job_ends};
    qtri_stroker_draw(&stroker, &source);
}

void qtri_draw_wide_lines(const qtri_surface *surface, const qtri_view *view,
                          const qtri_transform *pose, const qtri_corner *corners,
                          uint32_t corner_count, const qtri_stroke *stroke,
                          const qtri_material *material)
{
    QTRI_CHECK(qtri_check_surface(surface));
    QTRI_CHECK(qtri_check_material(material));
    QTRI_CHECK(qtri_check_view(view, pose));
    QTRI_CHECK(qtri_check_stroke(stroke));
    QTRI_CHECK(qtri_check_corners(corners, corner_count, 2));
    qtri_stroke_job job;
    qtri_stroker stroker;
    if (!qtri_stroker_init(&stroker, surface, material, stroke)) {
        return;
    }
    qtri_stroke_job_init(&job, view, pose, corners, 2, stroke, material);
    if (job.radius == 0) {
        return;
    }
    const qtri_stroke_source source = {&job, 1, qtri_stroke_job_place, qtri_stroke_job_ends};
    for (uint32_t i = 0; corner_count - i >= 2; i += 2) {
        qtri_vertex v[2];
        job.corners = &corners[i];
        job.kept = 0;
        qtri_stroke_job_vertex(&job, 0, &v[0]);
        qtri_stroke_job_vertex(&job, 1, &v[1]);
        job.vertices = v;
        job.kept = 2;
        qtri_stroker_draw(&stroker, &source);
    }
}
