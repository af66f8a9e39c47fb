#include "texel.h"

#include "../bits/bits.h"
#include "texel_format.h"

static int64_t hold_q32(int64_t coordinate)
{
    const int64_t limit = (int64_t)1 << 48;
    return coordinate < -limit ? -limit : (coordinate > limit ? limit : coordinate);
}

/* Added to values, so that those somewhat below 0 can be shifted; a multiple of the side. */
#define ABOVE_ZERO ((uint32_t)1 << 30)

void qtri_texel_axis_init(qtri_texel_axis *axis, uint32_t value[3], const int64_t coordinate_q32[3],
                          uint8_t side_log2)
{
    uint64_t offset[3];
    uint64_t all = 0;
    int32_t base = INT32_MAX; /* whole repeats below the least: |base| <= 2^16 */
    for (int i = 0; i < 3; i++) {
        int64_t held = hold_q32(coordinate_q32[i]);
        int32_t repeats = (int32_t)(held >> 32);
        base = repeats < base ? repeats : base;
        offset[i] = (uint64_t)held;
    }
    for (int i = 0; i < 3; i++) {
        offset[i] -= (uint64_t)(uint32_t)base << 32; /* 0..2^50; what is lost of the base wraps */
        all |= offset[i];
    }
    /* The span to below 2^30; at least 3 bits go, which leaves shift <= 29. */
    int32_t down = 34 - qtri_clz64(all);
    down = down < 3 ? 3 : down; /* <= 20 */
    for (int i = 0; i < 3; i++) {
        value[i] = (uint32_t)(offset[i] >> down);
    }
    side_log2 = qtri_side_log2(side_log2);
    const int32_t shift = 32 - down - side_log2;
    axis->shift = (uint8_t)shift;
    axis->mask = (uint16_t)((1u << side_log2) - 1);
    axis->first = (int32_t)(ABOVE_ZERO >> shift) - base * ((int32_t)1 << side_log2);
    axis->bias = shift > 17 ? (uint32_t)1 << (shift - 16) : 2;
}

bool qtri_texture_usable(const qtri_texture *texture)
{
    return texture != NULL && texture->format != NULL && texture->format->usable(texture);
}

/* As the colour key is compared. */
static uint32_t stored_texel(const qtri_texture *texture, uint32_t column, uint32_t row)
{
    const uint32_t number = (row << qtri_side_log2(texture->width_log2)) + column;
    uint32_t texel[4] = {number, number, number, number};
    texture->format->fetch(texel, texture, 1);
    return texel[0];
}

static qtri_rgb color_of(const qtri_texture *texture, uint32_t stored)
{
    const qtri_texel_format *format = texture->format;
    uint32_t texel[4] = {stored, stored, stored, stored};
    if (format->decode != NULL) {
        format->decode(texel, texture, 1);
    }
    return qtri_rgb_from_888(format->colors == &qtri_colors_565 ? qtri_decode_rgb565(texel[0])
                                                                : texel[0]);
}

static bool is_key(const qtri_texture *texture, uint32_t stored)
{
    return texture->has_key && ((stored ^ texture->key) & texture->format->key_mask) == 0;
}

/* texel / 255 in Q16, exact at 0 and 255 and within 2^-16 between: sum < 2^24 + 128. */
static int32_t fraction_q16(uint32_t texel_8p16)
{
    return (int32_t)((texel_8p16 + (texel_8p16 >> 8) + (texel_8p16 >> 16) + 128) >> 8);
}

/* Which texel of a side that repeats or ends. texel: (value + 2^30) >> shift, or the next. */
static uint32_t wrap(const qtri_texel_axis *axis, qtri_wrap mode, uint32_t texel)
{
    if (mode != QTRI_CLAMP) {
        return texel & axis->mask;
    }
    int32_t index = (int32_t)texel - axis->first; /* texel <= 2^30, |first| < 2^29 */
    return index < 0 ? 0 : ((uint32_t)index > axis->mask ? axis->mask : (uint32_t)index);
}

/* Two neighbours along one axis. */
typedef struct taps {
    uint32_t index[2];
    uint32_t weight; /* of the second, of 256 */
} taps;

/* Centres are half a texel on; half of a weight's last bit rounds. `value` has the bias added. */
static taps taps_at(const qtri_texel_axis *axis, qtri_wrap mode, uint32_t value)
{
    int32_t shift = axis->shift;
    uint32_t from_center = value - axis->bias + ABOVE_ZERO - ((uint32_t)1 << (shift - 1));
    if (shift > 8) {
        from_center += (uint32_t)1 << (shift - 9);
    }
    taps t;
    t.index[0] = wrap(axis, mode, from_center >> shift);
    t.index[1] = wrap(axis, mode, (from_center >> shift) + 1);
    t.weight = (shift > 8 ? from_center >> (shift - 8) : from_center << (8 - shift)) & 255;
    return t;
}

/* The weighted sum of four texels; `nearest` stands in for those that equal the key. */
static void bilinear(const qtri_texture *texture, const taps *u, const taps *v, qtri_rgb nearest,
                     uint32_t sum_8p16[3])
{
    sum_8p16[0] = sum_8p16[1] = sum_8p16[2] = 0;
    for (int i = 0; i < 4; i++) {
        int right = i & 1;
        int below = i >> 1;
        uint32_t weight = (right ? u->weight : 256 - u->weight) * /* the four sum to 2^16 */
                          (below ? v->weight : 256 - v->weight);
        uint32_t stored = stored_texel(texture, u->index[right], v->index[below]);
        qtri_rgb texel = is_key(texture, stored) ? nearest : color_of(texture, stored);
        sum_8p16[0] += weight * texel.r;
        sum_8p16[1] += weight * texel.g;
        sum_8p16[2] += weight * texel.b;
    }
}

bool qtri_texel_apply(const qtri_texture *texture, const qtri_texel_axis axis[2], uint32_t u,
                      uint32_t v, qtri_channels *color)
{
    uint32_t column = wrap(&axis[0], texture->wrap_u, (u + ABOVE_ZERO) >> axis[0].shift);
    uint32_t row = wrap(&axis[1], texture->wrap_v, (v + ABOVE_ZERO) >> axis[1].shift);
    uint32_t stored = stored_texel(texture, column, row);
    if (is_key(texture, stored)) {
        return false;
    }
    qtri_rgb texel = color_of(texture, stored);
    uint32_t texel_8p16[3] = {(uint32_t)texel.r << 16, (uint32_t)texel.g << 16,
                              (uint32_t)texel.b << 16};
    if (texture->filter != NULL) {
        taps along = taps_at(&axis[0], texture->wrap_u, u);
        taps across = taps_at(&axis[1], texture->wrap_v, v);
        bilinear(texture, &along, &across, texel, texel_8p16);
    }
    for (int i = 0; i < 3; i++) {
        color->c[i] = (int32_t)(qtri_mul_s32(color->c[i], fraction_q16(texel_8p16[i])) >> 16);
    }
    return true;
}
