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

/* Whether the screen door lets pixel (x, y) through. */
bool ref_passes_door(const struct scene *scene, int x, int y);

/* What alpha of vertex i of an operation is, 0..1: for blends that look at it, of triangles. */
double ref_vertex_alpha(const struct scene *scene, const struct scene_op *op, size_t i);

/* What becomes of a channel, 0..255, at window depth `depth` over what is `under` it, `alpha` being
   that of the vertices. */
double ref_blend(const struct scene *scene, int channel, double color, double under, double depth,
                 double alpha);

/* How much of what is stored a blend leaves, at most. */
double ref_kept(const struct scene *scene, double alpha);

#endif
