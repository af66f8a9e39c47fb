/* SPDX-License-Identifier: MIT */
#include "textured.h"

#include "bilinear.h"
#include "texel_copy.h"

void qtri_textured_init(qtri_raster *raster, const qtri_material *material)
{
    const qtri_texture *texture = material->texture;
    const qtri_format *format = raster->format;
    const bool narrow =
        texture->format->colors == &qtri_colors_565 && format->colors == &qtri_colors_565;
    raster->texture = texture;
    raster->replace = material->texture_mode == QTRI_REPLACE;
    raster->units = &qtri_colors_888;
    raster->working = narrow ? &qtri_colors_565 : &qtri_colors_888;
    raster->light = narrow ? qtri_light_565 : qtri_light_888;
    raster->times = narrow ? qtri_times_565 : qtri_times_888;
    raster->tinted = narrow ? qtri_tint_565 : qtri_tint_888;
    raster->widen = !narrow && texture->format->colors == &qtri_colors_565 ? qtri_565_to_888 : NULL;
    raster->narrow = NULL;
    if (format->colors == &qtri_colors_gray) {
        raster->narrow = qtri_888_to_gray;
    } else if (!narrow && format->colors == &qtri_colors_565) {
        raster->narrow = qtri_888_to_565;
    }
    raster->repeated = qtri_texel_copy_fits(texture);
    raster->texel_cut = raster->repeated ? qtri_texel_cut(texture) : 0;
    for (int i = 0; i < 2; i++) {
        const int32_t shift = qtri_texel_copy_shift(texture, i);
        raster->coordinate[i].shift = (uint8_t)shift;
        raster->coordinate[i].unit = (uint8_t)(i == 0 ? 32 : shift + texture->height_log2);
    }
#ifndef __OPTIMIZE_SIZE__
    raster->fetched = raster->repeated && texture->format->bytes == 2 && texture->filter == NULL;
#endif
    raster->copied = raster->repeated && narrow && format->encode == NULL &&
                     texture->format->bytes == 2 && texture->format->decode == NULL &&
                     texture->filter == NULL && !texture->has_key;
}

/* The mask of stored texels that are not the key. */
static uint32_t others_than_key(const qtri_texture *texture, const uint32_t *texel, int32_t count)
{
    const uint32_t key_mask = texture->format->key_mask;
    const uint32_t key = texture->key & key_mask;
    uint32_t mask = 0;
    for (const uint32_t *end = texel + count; texel != end; texel++) {
        mask = 2 * mask + ((*texel & key_mask) != key);
    }
    return mask;
}

uint32_t qtri_texels_color(const qtri_raster *raster, const qtri_texel_axis axis[2],
                           uint32_t *color, const uint32_t *v, int32_t count, bool fetched)
{
    const qtri_texture *texture = raster->texture;
    const qtri_texel_format *format = texture->format;
    uint32_t mask = UINT32_MAX;
    if (texture->filter != NULL) {
        return texture->filter->sample(raster, axis, color, v, count);
    }
    if (!fetched) {
        format->fetch(color, texture, count);
    }
    if (texture->has_key) {
        mask = others_than_key(texture, color, count);
    }
    if (mask != 0) {
        if (format->decode != NULL) {
            format->decode(color, texture, count);
        }
        if (raster->widen != NULL) {
            raster->widen(color, count);
        }
    }
    return mask;
}
