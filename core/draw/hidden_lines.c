/* SPDX-License-Identifier: MIT */
#include "qtri/pipeline_make.h"
#include "qtri/stroke.h"

#include "../bits/bits.h"
#include "checked.h"

/* Faces leave depth alone, most often where it is less. */
QTRI_PIPELINE(qtri_pipeline_depth_less, .format = QTRI_DEPTH_ONLY, .depth = QTRI_LINEAR16,
              .compare = QTRI_LESS)
static const qtri_pipeline *const faces[] = {&qtri_pipeline_depth_less, &qtri_pipeline_any, NULL};

/* A bias towards the eye, which is where the comparison says. */
static q16 nearer_by(const qtri_material *material, q16 bias)
{
    const bool is_greater =
        material->depth_compare == QTRI_GREATER || material->depth_compare == QTRI_GREATER_EQUAL;
    const q16 held = qtri_hold32(bias, 0, Q16_ONE);
    const int64_t sum = (int64_t)material->depth_bias + (is_greater ? held : -held);
    return qtri_saturate32(sum);
}

void qtri_draw_hidden_lines(const qtri_surface *surface, const qtri_view *view,
                            const qtri_transform *pose, const qtri_mesh *mesh,
                            const qtri_stroke *stroke, const qtri_material *material, q16 bias)
{
    QTRI_CHECK(qtri_check_surface(surface));
    QTRI_CHECK(qtri_check_material(material));
    QTRI_CHECK(qtri_check_view(view, pose));
    QTRI_CHECK(qtri_check_mesh(mesh));
    qtri_surface depth = *surface;
    qtri_material solid = *material;
    qtri_material lines = *material;
    qtri_view unlit = *view;
    if (surface->format != NULL) {
        depth.format = &qtri_depth_only;
    }
    solid.fill = NULL;
    solid.depth_read_only = false;
    solid.shading = QTRI_FLAT_LAST; /* of colours that nobody sees */
    if (solid.texture != NULL && !solid.texture->has_key && solid.least_alpha == 0) {
        solid.texture = NULL;
    }
    lines.fill = &qtri_wireframe;
    lines.depth_bias = nearer_by(material, bias);
    unlit.light = NULL;
    unlit.lights = NULL;
    unlit.pipelines = faces;
    solid.fog = NULL;
    qtri_draw_mesh(&depth, &unlit, pose, mesh, &solid);
    if (stroke != NULL) {
        qtri_draw_wide_wireframe(surface, view, pose, mesh, stroke, &lines);
    } else {
        qtri_draw_mesh(surface, view, pose, mesh, &lines);
    }
}
