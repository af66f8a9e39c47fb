/* SPDX-License-Identifier: MIT */
/*
 * The filters of textures with levels.
 */
#include "bilinear.h"
#include "mipmap.h"

/* Levels that can be used besides the first: their widths are 2 texels or more. */
static uint8_t last_level(const qtri_texture *texture)
{
    const int32_t width_log2 = qtri_side_log2(texture->width_log2);
    uint8_t last = 0;
    if (texture->levels != NULL) {
        while (last + 1 < width_log2 && last < texture->level_count &&
               texture->levels[last] != NULL) {
            last++;
        }
    }
    return last;
}

/* Where all pixels of a triangle are of one level, and where that changes along its rows. */
static const qtri_texturing stages[2] = {
    {qtri_textured_init, qtri_mipmap_axes, qtri_mipmap_begin_large, qtri_textured_chunk,
     qtri_mipmap_set_list, qtri_mipmap_color_list, qtri_mipmap_finish_list},
    {qtri_textured_init, qtri_mipmap_axes, qtri_mipmap_begin_large, qtri_mipmap_chunk,
     qtri_mipmap_set_list, qtri_mipmap_color_list, qtri_mipmap_finish_list}};

static void init(qtri_raster *raster)
{
    qtri_levels *levels = qtri_levels_of(raster);
    levels->whole = raster->texture;
    levels->raster = raster;
    levels->stages = stages;
    levels->axis = NULL;
    levels->texture = *raster->texture;
    levels->texture.filter = NULL;
    levels->level = 0;
    levels->waiting = 0;
    levels->down[0] = 0;
    levels->down[1] = 0;
    /* Samples of a pixel have jobs of their own, and levels only one at a time. */
    levels->last = raster->samples != NULL ? 0 : last_level(raster->texture);
    raster->texture = &levels->texture;
    if (levels->last != 0) {
        qtri_levels_vary(levels, false);
    }
}

static void init_bilinear(qtri_raster *raster)
{
    init(raster);
    qtri_levels_of(raster)->texture.filter = &qtri_bilinear;
    qtri_bilinear_init(raster);
}

/* Neither samples: the raster's texture has another filter, or none. */
const qtri_filter qtri_mipmapped = {init, NULL, false, true};
const qtri_filter qtri_mipmapped_bilinear = {init_bilinear, NULL, true, true};
