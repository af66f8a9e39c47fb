/* SPDX-License-Identifier: MIT */
/*
 * Formats of texels. Those with alpha become 0xAARRGGBB.
 */
#include "qtri/body/texel.h"
#include "qtri/texture.h"

#include "../frame/pixel.h"
#include "descriptions.h"

static bool has_texels(const qtri_texture *texture)
{
    return texture->texels != NULL;
}

static void fetch_8(uint32_t *texel, const qtri_texture *texture, int32_t count)
{
    const uint8_t *texels = texture->texels;
    QTRI_EACH_WORD(texel, count, number, texels[number])
}

static void fetch_16(uint32_t *texel, const qtri_texture *texture, int32_t count)
{
    const uint16_t *texels = texture->texels;
    QTRI_EACH_WORD(texel, count, number, texels[number])
}

static void fetch_24(uint32_t *texel, const qtri_texture *texture, int32_t count)
{
    const uint32_t *texels = texture->texels;
    QTRI_EACH_WORD(texel, count, number, texels[number] & 0xFFFFFF)
}

static void fetch_32(uint32_t *texel, const qtri_texture *texture, int32_t count)
{
    const uint32_t *texels = texture->texels;
    QTRI_EACH_WORD(texel, count, number, texels[number])
}

static void decode_gray(uint32_t *texel, const qtri_texture *texture, int32_t count)
{
    (void)texture;
    QTRI_EACH_WORD(texel, count, gray, gray * 0x010101)
}

static void decode_4444(uint32_t *texel, const qtri_texture *texture, int32_t count)
{
    (void)texture;
    QTRI_EACH_WORD(texel, count, x, qtri_pixel_4444_to_8888(x))
}

static void decode_1555(uint32_t *texel, const qtri_texture *texture, int32_t count)
{
    (void)texture;
    QTRI_EACH_WORD(texel, count, x, qtri_pixel_1555_to_8888(x))
}

static void decode_alpha(uint32_t *texel, const qtri_texture *texture, int32_t count)
{
    (void)texture;
    QTRI_EACH_WORD(texel, count, x, x << 24 | 0xFFFFFFu)
}

static bool has_palette(const qtri_texture *texture)
{
    return texture->texels != NULL && texture->palette != NULL;
}

static void decode_palette(uint32_t *texel, const qtri_texture *texture, int32_t count)
{
    const qtri_rgb *palette = texture->palette;
    QTRI_EACH_WORD(texel, count, number, qtri_pixel_rgb_to_888(&palette[number]))
}

static void decode_palette565(uint32_t *texel, const qtri_texture *texture, int32_t count)
{
    const uint16_t *palette = texture->palette;
    QTRI_EACH_WORD(texel, count, number, palette[number])
}

static bool needs_nothing(const qtri_texture *texture)
{
    (void)texture;
    return true;
}

static void fetch_checker(uint32_t *texel, const qtri_texture *texture, int32_t count)
{
    const uint32_t width_log2 = qtri_side_log2(texture->width_log2);
    QTRI_EACH_WORD(texel, count, number, qtri_checker_field(texture, width_log2, number))
}

static void decode_checker(uint32_t *texel, const qtri_texture *texture, int32_t count)
{
    const uint32_t color[2] = {qtri_pixel_rgb_to_888(&texture->color[0]),
                               qtri_pixel_rgb_to_888(&texture->color[1])};
    QTRI_EACH_WORD(texel, count, odd, color[odd])
}

const qtri_texel_format qtri_texel_rgb565 = {&qtri_colors_565, UINT32_MAX, has_texels,
                                             fetch_16,         NULL,       QTRI_TEXEL_RGB565};
const qtri_texel_format qtri_texel_xrgb8888 = {&qtri_colors_888, 0xFFFFFF, has_texels,
                                               fetch_24,         NULL,     QTRI_TEXEL_XRGB8888};
const qtri_texel_format qtri_texel_gray8 = {&qtri_colors_888, UINT32_MAX,  has_texels,
                                            fetch_8,          decode_gray, QTRI_TEXEL_GRAY8};
const qtri_texel_format qtri_texel_palette8 = {
    &qtri_colors_888, UINT32_MAX, has_palette, fetch_8, decode_palette, QTRI_TEXEL_PALETTE8};
const qtri_texel_format qtri_texel_palette565 = {
    &qtri_colors_565, UINT32_MAX, has_palette, fetch_8, decode_palette565, QTRI_TEXEL_PALETTE565};
const qtri_texel_format qtri_texel_checker = {&qtri_colors_888, UINT32_MAX,     needs_nothing,
                                              fetch_checker,    decode_checker, QTRI_TEXEL_CHECKER};
const qtri_texel_format qtri_texel_argb4444 = {&qtri_colors_888, 0xFFFF,      has_texels,
                                               fetch_16,         decode_4444, QTRI_TEXEL_ARGB4444};
const qtri_texel_format qtri_texel_argb1555 = {&qtri_colors_888, 0xFFFF,      has_texels,
                                               fetch_16,         decode_1555, QTRI_TEXEL_ARGB1555};
const qtri_texel_format qtri_texel_argb8888 = {&qtri_colors_888, UINT32_MAX, has_texels,
                                               fetch_32,         NULL,       QTRI_TEXEL_ARGB8888};
const qtri_texel_format qtri_texel_alpha8 = {&qtri_colors_888, 0xFF,         has_texels,
                                             fetch_8,          decode_alpha, QTRI_TEXEL_ALPHA8};
