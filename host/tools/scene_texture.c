/* SPDX-License-Identifier: MIT */
#include "scene_draw.h"

#include <stdlib.h>
#include <string.h>

#include "../io/mipmap.h"
#include "../io/palette.h"
#include "../io/xalloc.h"

/* value of 255 as the nearest of steps + 1 levels; never a tie. */
static uint32_t level(uint8_t value, uint32_t steps)
{
    return (value * steps + 127) / 255;
}

/* An 8-bit colour and alpha as a texel; not for palettes. */
static uint32_t texel_of(enum scene_texel_format format, const uint8_t rgb[3], uint8_t alpha)
{
    switch (format) {
    case SCENE_TEXEL_ARGB4444:
        return level(alpha, 15) << 12 | level(rgb[0], 15) << 8 | level(rgb[1], 15) << 4 |
               level(rgb[2], 15);
    case SCENE_TEXEL_ARGB1555:
        return level(alpha, 1) << 15 | level(rgb[0], 31) << 10 | level(rgb[1], 31) << 5 |
               level(rgb[2], 31);
    case SCENE_TEXEL_ALPHA8:
        return alpha;
    case SCENE_TEXEL_RGB565:
        return level(rgb[0], 31) << 11 | level(rgb[1], 63) << 5 | level(rgb[2], 31);
    case SCENE_TEXEL_GRAY8:
        return (299u * rgb[0] + 587u * rgb[1] + 114u * rgb[2] + 500) / 1000;
    default:
        return (uint32_t)alpha << 24 | (uint32_t)rgb[0] << 16 | (uint32_t)rgb[1] << 8 | rgb[2];
    }
}

static void make_palette(struct scene_resources *resources, const struct scene *scene, size_t count)
{
    struct palette palette;
    /* The scene reader has refused what has more colours. */
    (void)palette_make(&palette, scene->texture.rgb, count, resources->texels);
    for (int i = 0; i < palette.count; i++) {
        const uint8_t *color = palette.color[i];
        qtri_rgb rgb = {color[0], color[1], color[2]};
        resources->palette[i] = rgb;
        resources->palette565[i] = (uint16_t)texel_of(SCENE_TEXEL_RGB565, color, 0);
    }
    int key = palette_find(&palette, scene->texture_key);
    resources->texture.has_key = scene->texture_keyed && key >= 0;
    resources->texture.key = (uint32_t)key;
}

/* alpha NULL: opaque, or without. */
static void store_texels(void *texels, enum scene_texel_format format, const uint8_t *rgb,
                         const uint8_t *alpha, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        uint32_t texel = texel_of(format, &rgb[3 * i], alpha != NULL ? alpha[i] : 0);
        switch (format) {
        case SCENE_TEXEL_RGB565:
        case SCENE_TEXEL_ARGB4444:
        case SCENE_TEXEL_ARGB1555:
            ((uint16_t *)texels)[i] = (uint16_t)texel;
            break;
        case SCENE_TEXEL_GRAY8:
        case SCENE_TEXEL_ALPHA8:
            ((uint8_t *)texels)[i] = (uint8_t)texel;
            break;
        default:
            ((uint32_t *)texels)[i] = texel;
            break;
        }
    }
}

static void make_texels(struct scene_resources *resources, const struct scene *scene, size_t count)
{
    store_texels(resources->texels, scene->texel_format, scene->texture.rgb, scene->texture.alpha,
                 count);
    resources->texture.has_key = scene->texture_keyed;
    resources->texture.key = texel_of(scene->texel_format, scene->texture_key, 0);
}

/* The texture's levels, behind it in the same memory. */
static void make_levels(struct scene_resources *resources, const struct scene *scene, size_t size)
{
    const struct scene_texture *from = &scene->texture;
    uint8_t *at = (uint8_t *)resources->texels + size * (size_t)from->width * (size_t)from->height;
    for (int i = 0; i < from->level_count; i++) {
        const size_t count =
            (size_t)mipmap_side(from->width, i + 1) * (size_t)mipmap_side(from->height, i + 1);
        resources->levels[i] = at;
        if (!scene_texel_has_palette(scene->texel_format)) {
            store_texels(at, scene->texel_format, from->level[i],
                         from->alpha != NULL ? from->level_alpha[i] : NULL, count);
        } else {
            for (size_t k = 0; k < count;
                 k++) { /* the scene reader has chosen colours that are there */
                const uint8_t *rgb = &from->level[i][3 * k];
                const qtri_rgb *entry = resources->palette;
                while (entry < &resources->palette[255] &&
                       (entry->r != rgb[0] || entry->g != rgb[1] || entry->b != rgb[2])) {
                    entry++;
                }
                at[k] = (uint8_t)(entry - resources->palette);
            }
        }
        at += size * count;
    }
    resources->texture.levels = resources->levels;
    resources->texture.level_count = (uint8_t)from->level_count;
    resources->texture.filter =
        scene->texture_bilinear ? &qtri_mipmapped_bilinear : &qtri_mipmapped;
}

/* What is stored of texel i. */
static uint32_t stored_texel(const qtri_texture *texture, size_t i)
{
    switch (texture->format->kind) {
    case QTRI_TEXEL_RGB565:
    case QTRI_TEXEL_ARGB4444:
    case QTRI_TEXEL_ARGB1555:
        return ((const uint16_t *)texture->texels)[i];
    case QTRI_TEXEL_XRGB8888:
    case QTRI_TEXEL_ARGB8888:
        return ((const uint32_t *)texture->texels)[i];
    default:
        return ((const uint8_t *)texture->texels)[i];
    }
}

/* White, and black for the key. */
static uint8_t shade_of_key(const qtri_texture *texture, size_t i)
{
    return ((stored_texel(texture, i) ^ texture->key) & texture->format->key_mask) == 0 ? 0 : 255;
}

/* How opaque what is stored is. */
static uint8_t shade_of_alpha(const qtri_texture *texture, size_t i)
{
    const uint32_t texel = stored_texel(texture, i);
    switch (texture->format->kind) {
    case QTRI_TEXEL_ARGB4444:
        return (uint8_t)((texel >> 12) * 17);
    case QTRI_TEXEL_ARGB1555:
        return (uint8_t)((texel >> 15) * 255);
    case QTRI_TEXEL_ALPHA8:
        return (uint8_t)texel;
    default:
        return (uint8_t)(texel >> 24);
    }
}

/* A texture of shades of the texture's texels, in `format`. Levels as the texture's, behind it in
   the same memory. */
static void make_shades(struct scene_resources *resources, const qtri_texel_format *format,
                        uint8_t (*shade_of)(const qtri_texture *texture, size_t i), size_t count)
{
    const qtri_texture *texture = &resources->texture;
    qtri_texture level = *texture;
    uint8_t *at = xcalloc(count, 2);
    resources->mask_texels = at;
    for (int i = 0; i <= texture->level_count; i++) {
        const size_t width = (size_t)1 << (texture->width_log2 - i);
        const size_t height = (size_t)1 << texture->height_log2 >> i;
        if (i > 0) {
            level.texels = texture->levels[i - 1];
            resources->mask_levels[i - 1] = at;
        }
        for (size_t k = 0; k < width * (height > 0 ? height : 1); k++) {
            *at++ = shade_of(&level, k);
        }
    }
    resources->mask = *texture;
    resources->mask.texels = resources->mask_texels;
    resources->mask.format = format;
    resources->mask.levels = resources->mask_levels;
}

static void make_mask(struct scene_resources *resources, size_t count)
{
    make_shades(resources, &qtri_texel_gray8, shade_of_key, count);
    resources->mask.filter = resources->texture.level_count > 0 ? &qtri_mipmapped : NULL;
    resources->mask.key = 0;
}

void scene_texture_create(struct scene_resources *resources, const struct scene *scene)
{
    static const struct {
        const qtri_texel_format *format;
        size_t size;
    } texel[] = {
        [SCENE_TEXEL_XRGB8888] = {&qtri_texel_xrgb8888, sizeof(uint32_t)},
        [SCENE_TEXEL_RGB565] = {&qtri_texel_rgb565, sizeof(uint16_t)},
        [SCENE_TEXEL_PALETTE] = {&qtri_texel_palette8, sizeof(uint8_t)},
        [SCENE_TEXEL_GRAY8] = {&qtri_texel_gray8, sizeof(uint8_t)},
        [SCENE_TEXEL_PALETTE565] = {&qtri_texel_palette565, sizeof(uint8_t)},
        [SCENE_TEXEL_ARGB4444] = {&qtri_texel_argb4444, sizeof(uint16_t)},
        [SCENE_TEXEL_ARGB1555] = {&qtri_texel_argb1555, sizeof(uint16_t)},
        [SCENE_TEXEL_ARGB8888] = {&qtri_texel_argb8888, sizeof(uint32_t)},
        [SCENE_TEXEL_ALPHA8] = {&qtri_texel_alpha8, sizeof(uint8_t)},
    };
    qtri_texture *texture = &resources->texture;
    size_t count = (size_t)scene->texture.width * (size_t)scene->texture.height;
    if (count == 0) {
        return;
    }
    resources->texels = xcalloc(2 * count, texel[scene->texel_format].size); /* levels too */
    texture->texels = resources->texels;
    texture->format = texel[scene->texel_format].format;
    texture->width_log2 = mipmap_log2(scene->texture.width);
    texture->height_log2 = mipmap_log2(scene->texture.height);
    texture->wrap_u = scene->texture_clamp[0] ? QTRI_CLAMP : QTRI_REPEAT;
    texture->wrap_v = scene->texture_clamp[1] ? QTRI_CLAMP : QTRI_REPEAT;
    texture->filter = scene->texture_bilinear ? &qtri_bilinear : NULL;
    texture->palette = scene->texel_format == SCENE_TEXEL_PALETTE565
                           ? (const void *)resources->palette565
                           : resources->palette;
    if (scene_texel_has_palette(scene->texel_format)) {
        make_palette(resources, scene, count);
    } else {
        make_texels(resources, scene, count);
    }
    if (scene->texture_mipmapped) {
        make_levels(resources, scene, texel[scene->texel_format].size);
    }
    if (scene_texel_has_alpha(scene->texel_format)) {
        make_shades(resources, &qtri_texel_alpha8, shade_of_alpha, count);
    } else if (texture->has_key) {
        make_mask(resources, count);
    }
}
