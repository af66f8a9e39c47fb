/* SPDX-License-Identifier: MIT */
/*
 * Pixels over pixels: fog by depth, and blends.
 */
#ifndef QTRI_HOST_REFERENCE_BLEND_H
#define QTRI_HOST_REFERENCE_BLEND_H

#include <stdbool.h>

#include "../io/scene.h"

/* Whether colours may leave the range of their triangle's vertices. */
bool ref_is_blended(const struct scene *scene);

/* Whether the screen door lets pixel (x, y) through. `opaque`, here and below: what is
   multiplied with the scene's alpha, a texel's times that of the vertices, 0..1. */
bool ref_passes_door(const struct scene *scene, double opaque, int x, int y);

/* What alpha of vertex i of an operation is, 0..1: for blends that look at it, of triangles. */
double ref_vertex_alpha(const struct scene *scene, const struct scene_op *op, size_t i);

/* What becomes of a channel, 0..255, at window depth `depth` over what is `under` it. */
double ref_blend(const struct scene *scene, int channel, double color, double opaque, double under,
                 double depth);

/* How much of what is stored a blend leaves, at most. */
double ref_kept(const struct scene *scene, double opaque);

#endif
