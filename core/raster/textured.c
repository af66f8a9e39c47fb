/* SPDX-License-Identifier: MIT */
#include "textured.h"

#include "bilinear.h"
#include "list_late.h"
#include "shading.h"
#include "loop.h"
#include "texel_copy.h"
#include "words.h"

/* Texels, colours that are multiplied and pixels, each in 565, in 8 bits a channel or in gray. */
static void set_kinds(qtri_raster *raster)
{
    const bool from_565 = raster->texture->format->colors == &qtri_colors_565;
    const bool to_565 = raster->format->colors == &qtri_colors_565;
    const bool to_gray = raster->format->colors == &qtri_colors_gray;
    const bool in_565 = from_565 && to_565;
    raster->working = in_565 ? &qtri_colors_565 : &qtri_colors_888;
    raster->gray = to_gray;
    raster->light = in_565 ? qtri_light_565 : qtri_light_888;
    raster->times = in_565 ? qtri_times_565 : qtri_times_888;
    raster->times_curves = in_565 ? qtri_times_curves_565 : qtri_times_curves_888;
    raster->tinted = in_565 ? qtri_tint_565 : qtri_tint_888;
    raster->widen = from_565 && !to_565 ? qtri_565_to_888 : NULL;
    raster->narrow = to_565 && !from_565 ? qtri_888_to_565 : NULL;
    raster->convert = from_565 ? raster->widen : raster->narrow;
    if (to_gray) {
        raster->light = qtri_light_gray;
        raster->times = qtri_times_gray;
        raster->times_curves = qtri_times_curves_gray;
        raster->tinted = qtri_tint_gray;
        raster->narrow = qtri_888_to_gray;
        raster->convert = from_565 ? qtri_565_to_gray : qtri_888_to_gray;
    }
}

void qtri_textured_set_coordinates(qtri_raster *raster)
{
    const qtri_texture *texture = raster->texture;
    for (int i = 0; i < 2; i++) {
        const int32_t shift = qtri_texel_copy_shift(texture, i);
        raster->coordinate[i].shift = (uint8_t)shift;
        raster->coordinate[i].unit = (uint8_t)(i == 0 ? 32 : shift + texture->height_log2);
    }
}

void qtri_textured_init(qtri_raster *raster, const qtri_material *material)
{
    const qtri_texture *texture = material->texture;
    const qtri_format *format = raster->format;
    raster->texture = texture;
    raster->varying = &qtri_varying_stages;
    raster->replace = material->texture_mode == QTRI_REPLACE;
    raster->units = &qtri_colors_888;
    raster->seen = NULL;
    if (raster->rejects && raster->late == NULL) {
        raster->late = &qtri_list_late_texels;
    }
    set_kinds(raster);
    if (texture->filter != NULL) {
        texture->filter->init(raster);
        texture = raster->texture;
    }
    raster->texel_cut = qtri_texel_copy_fits(texture) ? qtri_texel_cut(texture) : 0;
    raster->repeated =
        raster->texel_cut != 0 && texture->wrap_u != QTRI_CLAMP && texture->wrap_v != QTRI_CLAMP;
    qtri_textured_set_coordinates(raster);
#ifndef __OPTIMIZE_SIZE__
    raster->fetched =
        raster->texel_cut != 0 && texture->format->bytes == 2 && texture->filter == NULL;
#endif
    raster->copied = raster->repeated && raster->convert == NULL &&
                     raster->working == &qtri_colors_565 && format->encode == NULL &&
                     texture->format->bytes == 2 && texture->format->decode == NULL &&
                     texture->filter == NULL && !texture->has_key;
}

/* The mask of stored texels that are not the key: from the first, whose bit is the highest. */
static uint32_t others_than_key(const qtri_texture *texture, const uint32_t *texel, int32_t count)
{
    uint32_t key_mask = texture->format->key_mask;
    uint32_t key = texture->key & key_mask;
    uint32_t one = 1;
    uint32_t mask = 0;
    QTRI_OPAQUE(one)
#define ONE(i)                                                                                     \
    {                                                                                              \
        const uint32_t differ = (texel[i] & key_mask) ^ key;                                       \
        QTRI_PUSH_GREATER_EQUAL(mask, differ, one)                                                 \
        QTRI_ASIDE(key_mask)                                                                       \
    }
#define MOVE(n) texel += (n);
    const int32_t past = QTRI_WORDS_PAST(count);
    QTRI_WORDS(count)
#undef ONE
#undef MOVE
    return mask >> past;
}

uint32_t qtri_texels_color(const qtri_raster *raster, const qtri_texel_axis axis[2],
                           uint32_t *color, uint32_t *v, int32_t count, bool fetched, bool shaded)
{
    const qtri_texture *texture = raster->texture;
    const qtri_texel_format *format = texture->format;
    qtri_words_stage change = shaded ? raster->widen : raster->convert;
    uint32_t mask = UINT32_MAX;
    if (texture->filter != NULL) {
        mask = texture->filter->sample(raster, axis, color, v, count);
        change = shaded ? NULL : raster->narrow;
    } else {
        if (!fetched) {
            format->fetch(color, texture, count);
        }
        if (texture->has_key) {
            mask = others_than_key(texture, color, count);
            if (mask == 0) {
                return 0;
            }
        }
        if (format->decode != NULL) {
            format->decode(color, texture, count);
        }
        if (raster->seen != NULL) {
            mask &= raster->seen(raster, color, count);
        }
    }
    if (change != NULL) {
        change(color, count);
    }
    return mask;
}
