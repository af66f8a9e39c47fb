/* SPDX-License-Identifier: MIT */
/*
 * What a texture shows at a pair of coordinates.
 */
#ifndef QTRI_HOST_REFERENCE_TEXTURE_H
#define QTRI_HOST_REFERENCE_TEXTURE_H

#include <stdbool.h>

#include "../io/scene.h"
#include "primitive.h"

/*
 * The colour at (u, v), 0..255 a channel and not rounded: of the texels as the scene's format can
 * hold them, wrapped and filtered as it says, and their alpha, 255 without. False where the texel
 * under (u, v) has the key's colour, or alpha is less than what the scene draws. Bilinear filtering
 * takes that texel's colour for neighbours that have the key's. Of a texture that is mipmapped, the
 * level whose texels are nearest to the footprint's size.
 */
bool ref_texture_at(const struct scene *scene, double u, double v, double footprint,
                    double color[4]);

/*
 * How many texels of the whole texture a pixel is as large as: the longer of the steps to the right
 * and down, of which the length is the longer part and 3/8 of the other. weight: what the
 * attributes of the vertices count at the pixel, up to a factor; right, down: how fast that grows.
 * 0 where the scene's texture is not mipmapped.
 */
double ref_footprint(const struct scene *scene, const struct ref_vertex *const vertex[3],
                     const double weight[3], const double right[3], const double down[3]);

#endif
