/* SPDX-License-Identifier: MIT */
#include "texel_format.h"

static bool usable(const qtri_texture *texture)
{
    return texture->texels != NULL;
}

static void fetch(uint32_t *texel, const qtri_texture *texture, int32_t count)
{
    const uint32_t *texels = texture->texels;
    QTRI_EACH_WORD(texel, count, number, texels[number] & 0xFFFFFF)
}

const qtri_texel_format qtri_texel_xrgb8888 = {
    &qtri_texturing_stages, &qtri_colors_888, 0xFFFFFF, 0, usable, fetch, NULL,
    QTRI_TEXEL_XRGB8888};
