/*
 * What textures add to a raster: which stages texels go through. Internal.
 */
#ifndef QTRI_RASTER_TEXTURED_H
#define QTRI_RASTER_TEXTURED_H

#include "raster.h"
#include "stage_color.h"

#define QTRI_SHADE_WHITE ((uint32_t)1020 << QTRI_SHADE_RED | 1020u << QTRI_SHADE_GREEN | 1020u)

/* The raster's texture, if the material has one that can be read, and its stages. */
void qtri_texture_init(qtri_raster *raster, const qtri_material *material);

/*
 * Numbers of texels, texels (`fetched`), or u and v where they are filtered, become colours of the working kind.
 * Returns the mask of those that are drawn: the others are the colour key.
 */
uint32_t qtri_texels_color(const qtri_raster *raster, const qtri_texel_axis axis[2],
                           uint32_t *color, const uint32_t *v, int32_t count, bool fetched);

#endif
