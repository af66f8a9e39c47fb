/* SPDX-License-Identifier: MIT */
#include "texel_format.h"

static bool usable(const qtri_texture *texture)
{
    (void)texture;
    return true;
}

typedef struct board {
    uint32_t fields, column_mask;
    uint8_t width_log2, height_log2;
} board;

/* The parity of a texel's field. */
static inline uint32_t parity(const board *b, uint32_t number)
{
    const uint32_t column = number & b->column_mask;
    const uint32_t row = number >> b->width_log2;
    return ((column * b->fields >> b->width_log2) + (row * b->fields >> b->height_log2)) & 1;
}

static void fetch(uint32_t *texel, const qtri_texture *texture, int32_t count)
{
    board b = {.fields = texture->fields,
               .width_log2 = qtri_side_log2(texture->width_log2),
               .height_log2 = qtri_side_log2(texture->height_log2)};
    b.column_mask = ((uint32_t)1 << b.width_log2) - 1;
    QTRI_EACH_WORD(texel, count, number, parity(&b, number))
}

static inline uint32_t word_of(qtri_rgb color)
{
    return (uint32_t)color.r << 16 | (uint32_t)color.g << 8 | color.b;
}

static void decode(uint32_t *texel, const qtri_texture *texture, int32_t count)
{
    const uint32_t color[2] = {word_of(texture->color[0]), word_of(texture->color[1])};
    QTRI_EACH_WORD(texel, count, odd, color[odd])
}

const qtri_texel_format qtri_texel_checker = {
    &qtri_texturing_stages, &qtri_colors_888, UINT32_MAX, 0, usable, fetch, decode,
    QTRI_TEXEL_CHECKER};
