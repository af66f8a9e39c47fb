/* SPDX-License-Identifier: MIT */
/*
 * Bilinear filtering: the weighted sum of the four texels whose centres lie around a coordinate.
 *
 * Shares along an axis have 11 bits. Channels of 8 bits are multiplied by weights of 22 bits, whose
 * sum is exact; those of RGB565 by weights of 11 bits, so that red and blue are lanes of one word:
 * what is cut off the product of two shares, 1 of 2048 for each texel, is 2 63 / 2048 of a step at
 * most. A colour is then rounded once: within .57 of a step of RGB565 and .51 of 255, and off by
 * what the coordinate is.
 *
 * Coordinates are counted from the texels' centres: half a texel less than elsewhere.
 */
#include "bilinear.h"

#include "loop.h"
#include "texel_copy.h"
#include "texel_number.h"

enum { TOGETHER = 8 }; /* pixels whose texels are fetched in one call */

/* What a texel counts: left and right, above and below. All are >= 0. */
typedef struct weights {
    uint32_t left_above, right_above, left_below, right_below;
} weights;

/* Of 2^22, from shares of the right ones and of the lower ones, of 2048. */
QTRI_IN_PLACE weights exact_weights(uint32_t along, uint32_t across)
{
    weights w;
    w.right_below = along * across;
    w.right_above = (along << 11) - w.right_below;
    w.left_below = (across << 11) - w.right_below;
    w.left_above = ((uint32_t)1 << 22) - (along << 11) - w.left_below;
    return w;
}

/* Of 2^11. */
QTRI_IN_PLACE weights short_weights(uint32_t along, uint32_t across)
{
    weights w;
    w.right_below = along * across >> 11;
    w.right_above = along - w.right_below;
    w.left_below = across - w.right_below;
    w.left_above = 2048 - along - w.left_below;
    return w;
}

/*
 * Red and blue, 31 2^11 < 2^16 each; green where a pixel has it, 63 2^11 2^5 < 2^22. With masks,
 * that Armv6-M has no room for in instructions.
 */
typedef struct lanes {
    uint32_t red_blue, green;
    uint32_t red_blue_mask, green_mask;
} lanes;

/* The half that rounds. */
QTRI_IN_PLACE void begin_565(lanes *sum)
{
    sum->red_blue = 0x04000400u;
    sum->green = 0x8000u;
}

/* Adds a texel. The barriers keep GCC 12 from taking all four apart at once. */
QTRI_IN_PLACE void add_565(lanes *sum, uint32_t texel, uint32_t weight)
{
    QTRI_ASIDE(sum->red_blue_mask)
    QTRI_ASIDE(sum->green_mask)
    sum->red_blue += ((texel | texel << 5) & sum->red_blue_mask) * weight;
    QTRI_OPAQUE(sum->red_blue)
    sum->green += (texel & sum->green_mask) * weight;
    QTRI_OPAQUE(sum->green)
}

static inline uint32_t color_565(const lanes *sum)
{
    const uint32_t both = sum->red_blue >> 11 & sum->red_blue_mask;
    return (sum->green >> 11 & sum->green_mask) | both | both >> 5;
}

/* Sums of channels, below 2^30. */
typedef struct sums {
    uint32_t r, g, b;
} sums;

QTRI_IN_PLACE void add_888(sums *s, uint32_t texel, uint32_t weight)
{
    s->r += (texel << 8 >> 24) * weight;
    QTRI_OPAQUE(s->r)
    s->g += (texel << 16 >> 24) * weight;
    QTRI_OPAQUE(s->g)
    s->b += (texel << 24 >> 24) * weight;
    QTRI_OPAQUE(s->b)
}

static inline uint32_t color_888(const sums *s)
{
    const uint32_t half = (uint32_t)1 << 21;
    return (s->r + half) >> 22 << 16 | (s->g + half) >> 22 << 8 | (s->b + half) >> 22;
}

QTRI_IN_PLACE void add_565_exactly(sums *s, uint32_t texel, uint32_t weight)
{
    s->r += (texel >> 11) * weight;
    QTRI_OPAQUE(s->r)
    s->g += (texel << 21 >> 26) * weight;
    QTRI_OPAQUE(s->g)
    s->b += (texel << 27 >> 27) * weight;
    QTRI_OPAQUE(s->b)
}

/* 255 / 31 and 255 / 63 of 11 bits of the sum's fraction: .01 of a step besides the rounding. */
static inline uint32_t color_565_to_888(const sums *s)
{
    const uint32_t red = ((s->r >> 11) * 8423u + 0x100000u) >> 21;
    const uint32_t green = ((s->g >> 12) * 4145u + 0x80000u) >> 20;
    const uint32_t blue = ((s->b >> 11) * 8423u + 0x100000u) >> 21;
    return red << 16 | green << 8 | blue;
}

static inline uint32_t rotated_right(uint32_t x, uint32_t by)
{
    return x >> by | x << (32 - by);
}

/*
 * Texels that equal the key are neither drawn nor seen through the filter: the nearest of the four
 * decides whether the pixel is, and stands in for the others that equal the key.
 */
QTRI_NOINLINE static bool replace_keys(uint32_t tap[4], uint32_t key, uint32_t key_mask,
                                       uint32_t along, uint32_t across)
{
    const uint32_t nearest = tap[(across >> 10) * 2 + (along >> 10)];
    for (int i = 0; i < 4; i++) {
        tap[i] = (tap[i] & key_mask) == key ? nearest : tap[i];
    }
    return (nearest & key_mask) == key;
}

/*
 * Texels of RGB565 where coordinates fill 32 bits, see texel_copy.h, as most do, are read where
 * they are. `wide`: to 8 bits a channel. Without keys all are drawn.
 */
QTRI_IN_PLACE uint32_t sample_rgb565(const qtri_texture *texture, uint32_t *u, const uint32_t *v,
                                     int32_t count, bool wide, bool keyed)
{
    const uint16_t *texels = texture->texels;
    const uint32_t width_log2 = texture->width_log2;
    const uint32_t width = (uint32_t)1 << width_log2;
    const uint32_t rows = (((uint32_t)1 << texture->height_log2) - 1) << width_log2;
    const uint32_t key = texture->key;
    const uint32_t to_column = 32 - width_log2; /* 22..31 */
    lanes s = {0, 0, 0x001F001Fu, 0x7E0};
    const uint32_t *end = u + count;
    uint32_t drawn = 0;
    do {
        const uint32_t x = rotated_right(*u, to_column);
        const uint32_t y = *v++;
        const uint32_t along = x >> 21;
        const uint32_t left = x & (width - 1);
        const uint32_t right = (left + 1) & (width - 1);
        const uint32_t across = y << (16 - width_log2) >> 21;
        const uint32_t above = y >> 16 & rows;
        const uint16_t *row = texels + above;
        uint32_t tap[4];
        tap[0] = row[left];
        tap[1] = row[right];
        row = texels + ((above + width) & rows);
        tap[2] = row[left];
        tap[3] = row[right];
        if (keyed) {
            drawn = 2 * drawn + 1;
            if (tap[0] == key || tap[1] == key || tap[2] == key || tap[3] == key) {
                uint32_t replaced[4] = {tap[0], tap[1], tap[2], tap[3]};
                drawn -= replace_keys(replaced, key, UINT32_MAX, along, across);
                for (int i = 0; i < 4; i++) {
                    tap[i] = replaced[i];
                }
            }
        }
        if (wide) {
            const weights w = exact_weights(along, across);
            sums exact = {0, 0, 0};
            add_565_exactly(&exact, tap[0], w.left_above);
            add_565_exactly(&exact, tap[1], w.right_above);
            add_565_exactly(&exact, tap[2], w.left_below);
            add_565_exactly(&exact, tap[3], w.right_below);
            *u++ = color_565_to_888(&exact);
        } else {
            const weights w = short_weights(along, across);
            begin_565(&s);
            add_565(&s, tap[0], w.left_above);
            add_565(&s, tap[1], w.right_above);
            add_565(&s, tap[2], w.left_below);
            add_565(&s, tap[3], w.right_below);
            *u++ = color_565(&s);
        }
    } while (u != end);
    return keyed ? drawn : qtri_mask_of(count);
}

#ifdef __OPTIMIZE_SIZE__
static uint32_t rgb565(const qtri_texture *texture, uint32_t *u, const uint32_t *v, int32_t count,
                       bool wide, bool keyed)
{
    return sample_rgb565(texture, u, v, count, wide, keyed);
}
#else
#define RGB565(name, wide, keyed)                                                                  \
    QTRI_NOINLINE static uint32_t name(const qtri_texture *texture, uint32_t *u,                   \
                                       const uint32_t *v, int32_t count)                           \
    {                                                                                              \
        return sample_rgb565(texture, u, v, count, wide, keyed);                                   \
    }
RGB565(plain_565, false, false)
RGB565(plain_888, true, false)
RGB565(keyed_565, false, true)
RGB565(keyed_888, true, true)

static uint32_t rgb565(const qtri_texture *texture, uint32_t *u, const uint32_t *v, int32_t count,
                       bool wide, bool keyed)
{
    if (keyed) {
        return (wide ? keyed_888 : keyed_565)(texture, u, v, count);
    }
    return (wide ? plain_888 : plain_565)(texture, u, v, count);
}
#endif

/* Two neighbours along one axis, whose centres are half a texel on. */
typedef struct taps {
    uint32_t index[2];
    uint32_t weight; /* of the second, of 2048 */
} taps;

static inline taps taps_at(const qtri_texel_axis *axis, uint32_t value)
{
    const int32_t shift = axis->texel_shift;
    taps t;
    t.index[0] = qtri_texel_wrapped(axis, value >> shift);
    t.index[1] = qtri_texel_wrapped(axis, (value >> shift) + 1);
    t.weight = (shift > 11 ? value >> (shift - 11) : value << (11 - shift)) & 2047;
    return t;
}

/* The numbers of four texels a pixel, and the weights. */
static void find_taps(uint32_t *tap, uint32_t *weight, const qtri_texel_axis axis[2],
                      const uint32_t *u, const uint32_t *v, int32_t count)
{
    int32_t i = 0;
    do {
        const taps along = taps_at(&axis[0], u[i]);
        const taps across = taps_at(&axis[1], v[i]);
        const uint32_t above = across.index[0] << axis[0].side_log2;
        const uint32_t below = across.index[1] << axis[0].side_log2;
        tap[0] = above + along.index[0];
        tap[1] = above + along.index[1];
        tap[2] = below + along.index[0];
        tap[3] = below + along.index[1];
        tap += 4;
        weight[i] = across.weight << 16 | along.weight;
    } while (++i < count);
}

/* The same where coordinates fill 32 bits: those of texel_copy.h. */
static void find_repeated_taps(uint32_t *tap, uint32_t *weight, const qtri_texture *texture,
                               const uint32_t *u, const uint32_t *v, int32_t count)
{
    const uint32_t width_log2 = texture->width_log2;
    const uint32_t width = (uint32_t)1 << width_log2;
    const uint32_t rows = (((uint32_t)1 << texture->height_log2) - 1) << width_log2;
    const uint32_t *end = u + count;
    do {
        const uint32_t x = *u;
        const uint32_t y = *v++;
        const uint32_t left = x >> (32 - width_log2);
        const uint32_t right = (left + 1) & (width - 1);
        const uint32_t above = y >> 16 & rows;
        const uint32_t below = (above + width) & rows;
        tap[0] = above + left;
        tap[1] = above + right;
        tap[2] = below + left;
        tap[3] = below + right;
        tap += 4;
        *weight++ = y << (16 - width_log2) >> 21 << 16 | x << width_log2 >> 21;
    } while (++u != end);
}

/* Where keys are, in taps of `count` pixels: the mask of pixels that are drawn. */
static uint32_t without_keys(const qtri_texture *texture, uint32_t *tap, const uint32_t *weight,
                             int32_t count)
{
    const uint32_t key_mask = texture->format->key_mask;
    const uint32_t key = texture->key & key_mask;
    uint32_t drawn = 0;
    for (; count > 0; count--, tap += 4, weight++) {
        drawn = 2 * drawn + 1;
        if ((tap[0] & key_mask) == key || (tap[1] & key_mask) == key ||
            (tap[2] & key_mask) == key || (tap[3] & key_mask) == key) {
            drawn -= replace_keys(tap, key, key_mask, *weight & 2047, *weight >> 16);
        }
    }
    return drawn;
}

QTRI_NOINLINE static void blend(uint32_t *color, const uint32_t *tap, const uint32_t *weight,
                                int32_t count)
{
    for (int32_t i = 0; i < count; i++, tap += 4) {
        const uint32_t both = weight[i];
        const weights w = exact_weights(both & 2047, both >> 16);
        sums s = {0, 0, 0};
        add_888(&s, tap[0], w.left_above);
        add_888(&s, tap[1], w.right_above);
        add_888(&s, tap[2], w.left_below);
        add_888(&s, tap[3], w.right_below);
        color[i] = color_888(&s);
    }
}

QTRI_NOINLINE static void blend_565(uint32_t *color, const uint32_t *tap, const uint32_t *weight,
                                    int32_t count)
{
    lanes s = {0, 0, 0x001F001Fu, 0x7E0};
    for (int32_t i = 0; i < count; i++, tap += 4) {
        const uint32_t both = weight[i];
        const weights w = short_weights(both & 2047, both >> 16);
        begin_565(&s);
        add_565(&s, tap[0], w.left_above);
        add_565(&s, tap[1], w.right_above);
        add_565(&s, tap[2], w.left_below);
        add_565(&s, tap[3], w.right_below);
        color[i] = color_565(&s);
    }
}

/* Up to TOGETHER pixels of any format. Returns the mask of those that are drawn. */
static uint32_t sample_some(const qtri_raster *raster, const qtri_texel_axis axis[2], uint32_t *u,
                            const uint32_t *v, int32_t count)
{
    const qtri_texture *texture = raster->texture;
    uint32_t tap[4 * TOGETHER];
    uint32_t weight[TOGETHER];
    uint32_t drawn = qtri_mask_of(count);
    if (axis == NULL) {
        find_repeated_taps(tap, weight, texture, u, v, count);
    } else {
        find_taps(tap, weight, axis, u, v, count);
    }
    texture->format->fetch(tap, texture, 4 * count);
    if (texture->has_key) {
        drawn = without_keys(texture, tap, weight, count);
    }
    if (texture->format->decode != NULL) {
        texture->format->decode(tap, texture, 4 * count);
    }
    if (raster->widen != NULL) {
        raster->widen(tap, 4 * count);
    }
    raster->mix_taps(u, tap, weight, count);
    return drawn;
}

/* Coordinates as texel_axis.h has them, of small triangles. */
static void fill_32_bits(uint32_t *at, const qtri_texel_axis *axis, int32_t to, int32_t count)
{
    if (axis->clamped) {
        qtri_texel_coordinates_held(at, axis, to, count);
    } else if (to != axis->texel_shift) {
        const int32_t up = to - axis->texel_shift;
        for (const uint32_t *end = at + count; at != end; at++) {
            *at = up >= 0 ? *at << up : *at >> -up;
        }
    }
}

static uint32_t sample(const qtri_raster *raster, const qtri_texel_axis axis[2], uint32_t *u,
                       uint32_t *v, int32_t count)
{
    const qtri_texture *texture = raster->texture;
    const uint32_t *first = u;
    uint32_t drawn = 0;
    if (axis != NULL && raster->texel_cut != 0) {
        fill_32_bits(u, &axis[0], raster->coordinate[0].shift, count);
        fill_32_bits(v, &axis[1], raster->coordinate[1].shift, count);
        axis = NULL;
    }
    if (axis == NULL && texture->format == &qtri_texel_rgb565) {
        return rgb565(texture, u, v, count, raster->working != &qtri_colors_565, texture->has_key);
    }
    for (;;) {
        const int32_t some = count < TOGETHER ? count : TOGETHER;
        drawn = drawn << some | sample_some(raster, axis, u, v, some);
        count -= some;
        u += some;
        if (count == 0) {
            return raster->seen == NULL ? drawn
                                        : drawn & raster->seen(raster, first, (int32_t)(u - first));
        }
        v += some;
    }
}

void qtri_bilinear_init(qtri_raster *raster)
{
    raster->mix_taps = raster->working == &qtri_colors_565 ? blend_565 : blend;
}

const qtri_filter qtri_bilinear = {qtri_bilinear_init, sample, true, false};
