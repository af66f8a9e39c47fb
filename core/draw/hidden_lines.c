/* SPDX-License-Identifier: MIT */
#include "qtri/stroke.h"

#include "../bits/bits.h"

/* The range of depth, moved towards the eye by `bias`, which is where the comparison says. */
static void move_nearer(qtri_viewport *viewport, qtri_compare compare, q16 bias)
{
    const bool is_greater = compare == QTRI_GREATER || compare == QTRI_GREATER_EQUAL;
    const q16 held = qtri_hold32(bias, 0, Q16_ONE);
    const q16 by = is_greater ? held : -held;
    const q16 near_z = qtri_hold32(viewport->depth_near, 0, Q16_ONE);
    const q16 far_z = qtri_hold32(viewport->depth_far, 0, Q16_ONE);
    viewport->depth_near = qtri_hold32(near_z + by, 0, Q16_ONE);
    viewport->depth_far = qtri_hold32(far_z + by, 0, Q16_ONE);
}

void qtri_draw_hidden_lines(const qtri_surface *surface, const qtri_view *view,
                            const qtri_transform *pose, const qtri_mesh *mesh,
                            const qtri_stroke *stroke, const qtri_material *material, q16 bias)
{
    qtri_surface depth = *surface;
    qtri_material solid = *material;
    qtri_material lines = *material;
    qtri_view nearer = *view;
    if (surface->format != NULL) {
        depth.format = &qtri_depth_only;
    }
    solid.fill = NULL;
    solid.depth_read_only = false;
    solid.shading = QTRI_FLAT_LAST; /* of colours that nobody sees */
    if (solid.texture != NULL && !solid.texture->has_key) {
        solid.texture = NULL;
    }
    lines.fill = &qtri_wireframe;
    nearer.light = NULL;
    qtri_draw_mesh(&depth, &nearer, pose, mesh, &solid);
    nearer.light = view->light;
    move_nearer(&nearer.viewport, material->depth_compare, bias);
    if (stroke != NULL) {
        qtri_draw_wide_wireframe(surface, &nearer, pose, mesh, stroke, &lines);
    } else {
        qtri_draw_mesh(surface, &nearer, pose, mesh, &lines);
    }
}
