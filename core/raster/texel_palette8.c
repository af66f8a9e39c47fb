/* SPDX-License-Identifier: MIT */
#include "texel_format.h"

static bool usable(const qtri_texture *texture)
{
    return texture->texels != NULL && texture->palette != NULL;
}

static void fetch(uint32_t *texel, const qtri_texture *texture, int32_t count)
{
    const uint8_t *texels = texture->texels;
    QTRI_EACH_WORD(texel, count, number, texels[number])
}

static inline uint32_t entry(const qtri_rgb *palette, uint32_t number)
{
    const qtri_rgb *color = &palette[number];
    return (uint32_t)color->r << 16 | (uint32_t)color->g << 8 | color->b;
}

static void decode(uint32_t *texel, const qtri_texture *texture, int32_t count)
{
    const qtri_rgb *palette = texture->palette;
    QTRI_EACH_WORD(texel, count, number, entry(palette, number))
}

const qtri_texel_format qtri_texel_palette8 = {
    &qtri_texturing_stages, &qtri_colors_888, UINT32_MAX, 0, usable, fetch, decode,
    QTRI_TEXEL_PALETTE8};
