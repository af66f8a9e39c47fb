/* SPDX-License-Identifier: MIT */
/*
 * Draws the lines and points of a scene with the fixed-point core.
 */
#ifndef QTRI_HOST_TOOLS_SCENE_STROKE_H
#define QTRI_HOST_TOOLS_SCENE_STROKE_H

#include <qtri.h>

#include "../io/scene.h"

/* How lines of the scene are drawn on a surface; for ids hard and opaque. */
qtri_stroke scene_stroke_of(const struct scene *scene, const struct scene_stroke *from,
                            const qtri_surface *surface, bool for_ids);

/* id: what to draw in place of the colours, with hard edges; NULL: the colours. */
void scene_draw_stroke(const struct scene *scene, const struct scene_op *op,
                       const qtri_surface *surface, const qtri_view *view,
                       const qtri_transform *modelview, const qtri_material *material,
                       const qtri_rgb *id);

#endif
