/* SPDX-License-Identifier: MIT */
#include "texel_format.h"

static bool usable(const qtri_texture *texture)
{
    return texture->texels != NULL;
}

static void fetch(uint32_t *texel, const qtri_texture *texture, int32_t count)
{
    const uint8_t *texels = texture->texels;
    QTRI_EACH_WORD(texel, count, number, texels[number])
}

static void decode(uint32_t *texel, const qtri_texture *texture, int32_t count)
{
    (void)texture;
    QTRI_EACH_WORD(texel, count, gray, gray * 0x010101)
}

const qtri_texel_format qtri_texel_gray8 = {
    &qtri_texturing_stages, &qtri_colors_888, UINT32_MAX, 0, usable, fetch, decode,
    QTRI_TEXEL_GRAY8};
