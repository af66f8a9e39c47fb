/* SPDX-License-Identifier: MIT */
#include "texel_format.h"

static bool usable(const qtri_texture *texture)
{
    return texture->texels != NULL;
}

static void fetch(uint32_t *texel, const qtri_texture *texture, int32_t count)
{
    const uint16_t *texels = texture->texels;
    QTRI_EACH_WORD(texel, count, number, texels[number])
}

const qtri_texel_format qtri_texel_rgb565 = {
    &qtri_texturing_stages, &qtri_colors_565, UINT32_MAX, 2, usable, fetch, NULL,
    QTRI_TEXEL_RGB565};
