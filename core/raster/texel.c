#include "texel.h"

#include "../math/bits.h"

#define SIDE_LOG2_MAX 10

static uint8_t side_log2_of(uint8_t log2)
{
    return log2 > SIDE_LOG2_MAX ? SIDE_LOG2_MAX : log2;
}

static int64_t hold_q32(int64_t coordinate)
{
    const int64_t limit = (int64_t)1 << 48;
    return coordinate < -limit ? -limit : (coordinate > limit ? limit : coordinate);
}

void qtri_texel_axis_init(qtri_texel_axis *axis, const int64_t coordinate_q32[3], uint8_t side_log2)
{
    int64_t offset[3];
    int64_t least = hold_q32(coordinate_q32[0]);
    int64_t greatest = least;
    for (int i = 0; i < 3; i++) {
        offset[i] = hold_q32(coordinate_q32[i]);
        least = offset[i] < least ? offset[i] : least;
        greatest = offset[i] > greatest ? offset[i] : greatest;
    }
    int64_t base = least - (least & (int64_t)UINT32_MAX);
    /* The span, below 2^50, to below 2^30; at least 3 bits go, which leaves shift <= 29. */
    int32_t down = 34 - qtri_clz64((uint64_t)(greatest - base));
    down = down < 3 ? 3 : down; /* <= 20 */
    for (int i = 0; i < 3; i++) {
        axis->value[i] = (offset[i] - base) >> down;
    }
    side_log2 = side_log2_of(side_log2);
    axis->shift = 32 - down - side_log2; /* >= 2 */
    axis->mask = (1u << side_log2) - 1;
    axis->bias = axis->shift > 17 ? (uint32_t)1 << (axis->shift - 16) : 2;
}

bool qtri_texture_usable(const qtri_texture *texture)
{
    return texture != NULL && (texture->texels != NULL || texture->format == QTRI_TEXEL_CHECKER);
}

qtri_rgb qtri_texel_fetch(const qtri_texture *texture, uint32_t column, uint32_t row)
{
    uint8_t width_log2 = side_log2_of(texture->width_log2);
    uint32_t index = (row << width_log2) + column;
    switch (texture->format) {
    case QTRI_TEXEL_RGB565:
        return qtri_rgb_from_565(((const uint16_t *)texture->texels)[index]);
    case QTRI_TEXEL_XRGB8888:
        return qtri_rgb_from_8888(((const uint32_t *)texture->texels)[index]);
    default: {
        uint32_t field_column = (column * texture->fields) >> width_log2;
        uint32_t field_row = (row * texture->fields) >> side_log2_of(texture->height_log2);
        return texture->color[(field_column + field_row) & 1];
    }
    }
}

/* texel / 255 in Q16, exact at 0 and 255 and within 2^-16 between. */
static int64_t fraction_q16(uint8_t texel)
{
    return texel * 257 + (texel >> 7);
}

qtri_channels qtri_texel_modulate(const qtri_channels *color, qtri_rgb texel)
{
    qtri_channels result;
    result.c[0] = (int32_t)((color->c[0] * fraction_q16(texel.r)) >> 16);
    result.c[1] = (int32_t)((color->c[1] * fraction_q16(texel.g)) >> 16);
    result.c[2] = (int32_t)((color->c[2] * fraction_q16(texel.b)) >> 16);
    return result;
}
