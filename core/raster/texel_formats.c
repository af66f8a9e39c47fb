/* SPDX-License-Identifier: MIT */
/*
 * Formats of texels. Pipelines read them by their kind: body/texel.h.
 */
#include "qtri/texture.h"

#include <stddef.h>

static bool has_texels(const qtri_texture *texture)
{
    return texture->texels != NULL;
}

static bool has_palette(const qtri_texture *texture)
{
    return texture->texels != NULL && texture->palette != NULL;
}

static bool needs_nothing(const qtri_texture *texture)
{
    (void)texture;
    return true;
}

#define TEXEL_FORMAT(name, kind, colors, mask, usable)                                             \
    const qtri_texel_format qtri_texel_##name = {&qtri_colors_##colors, mask, usable, NULL, NULL,  \
                                                 QTRI_TEXEL_##kind};

TEXEL_FORMAT(rgb565, RGB565, 565, UINT32_MAX, has_texels)
TEXEL_FORMAT(xrgb8888, XRGB8888, 888, 0xFFFFFF, has_texels)
TEXEL_FORMAT(gray8, GRAY8, 888, UINT32_MAX, has_texels)
TEXEL_FORMAT(palette8, PALETTE8, 888, UINT32_MAX, has_palette)
TEXEL_FORMAT(palette565, PALETTE565, 565, UINT32_MAX, has_palette)
TEXEL_FORMAT(checker, CHECKER, 888, UINT32_MAX, needs_nothing)
TEXEL_FORMAT(argb4444, ARGB4444, 888, 0xFFFF, has_texels)
TEXEL_FORMAT(argb1555, ARGB1555, 888, 0xFFFF, has_texels)
TEXEL_FORMAT(argb8888, ARGB8888, 888, UINT32_MAX, has_texels)
TEXEL_FORMAT(alpha8, ALPHA8, 888, 0xFF, has_texels)
