/* SPDX-License-Identifier: MIT */
/*
 * Wireframes of smooth lines, one pixel wide: as &qtri_wireframe, by other lines.
 */
#include "qtri/stroke.h"

#include "../raster/stroke_line.h"
#include "fill.h"

static const qtri_stroke_line one_pixel = {128, false, 255};

static void begin(qtri_primitive *primitive)
{
    qtri_primitive_begin_lines(primitive);
    qtri_stroke_line_choose(&primitive->to.lines.job, primitive->surface, primitive->material,
                            &one_pixel, qtri_stroke_line_draw);
}

static void draw_triangle(const qtri_mesh_job *draw, const void *triangle,
                          qtri_vertex *const vertex[3])
{
    qtri_wireframe.triangle(draw, triangle, vertex);
}

static void draw_mesh(qtri_mesh_job *draw)
{
    qtri_wireframe.mesh(draw);
}

static void prepare_mesh(const qtri_mesh_job *draw, bool back_only)
{
    qtri_wireframe.prepare(draw, back_only);
}

static void begin_band(qtri_mesh_job *draw)
{
    qtri_wireframe.band(draw);
}

const qtri_fill qtri_smooth_wireframe = {
    .begin = begin,
    .clipped = qtri_primitive_outline,
    .triangle = draw_triangle,
    .mesh = draw_mesh,
    .prepare = prepare_mesh,
    .band = begin_band,
};
