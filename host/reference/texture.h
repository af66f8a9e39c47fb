/* SPDX-License-Identifier: MIT */
/*
 * What a texture shows at a pair of coordinates.
 */
#ifndef QTRI_HOST_REFERENCE_TEXTURE_H
#define QTRI_HOST_REFERENCE_TEXTURE_H

#include <stdbool.h>

#include "../io/scene.h"

/*
 * The colour at (u, v), 0..255 a channel and not rounded: of the texels as the scene's format can
 * hold them, wrapped and filtered as it says. False where the texel under (u, v) has the key's
 * colour. Bilinear filtering takes that texel's colour for neighbours that have the key's.
 */
bool ref_texture_at(const struct scene *scene, double u, double v, double color[3]);

#endif
