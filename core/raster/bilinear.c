/* SPDX-License-Identifier: MIT */
/*
 * Bilinear filtering: the weighted sum of the four texels whose centres lie around a coordinate.
 *
 * Weights have 11 bits and the sum of each channel is taken as it is, so that a colour is rounded
 * once: within .51 of a step of RGB565 and .52 of 255, and off by what the coordinate is.
 */
#include "bilinear.h"

#include "loop.h"
#include "texel_copy.h"
#include "texel_number.h"

enum { TOGETHER = 8 }; /* pixels whose texels are fetched in one call */

/* Two neighbours along one axis, whose centres are half a texel on. */
typedef struct taps {
    uint32_t index[2];
    uint32_t weight; /* of the second, of 2048 */
} taps;

static inline taps taps_at(const qtri_texel_axis *axis, uint32_t value)
{
    const int32_t shift = axis->texel_shift;
    const uint32_t from_center = value - ((uint32_t)1 << (shift - 1));
    taps t;
    t.index[0] = qtri_texel_wrapped(axis, from_center >> shift);
    t.index[1] = qtri_texel_wrapped(axis, (from_center >> shift) + 1);
    t.weight = (shift > 11 ? from_center >> (shift - 11) : from_center << (11 - shift)) & 2047;
    return t;
}

/* A channel of the four, left and right, above and below: below 2^8 2^22 = 2^30. */
static inline uint32_t blended(uint32_t a, uint32_t b, uint32_t c, uint32_t d, uint32_t u,
                               uint32_t v)
{
    const uint32_t top = (a << 11) + (b - a) * u;
    const uint32_t bottom = (c << 11) + (d - c) * u;
    return ((top << 11) + (bottom - top) * v + ((uint32_t)1 << 21)) >> 22;
}

static inline uint32_t blended_888(uint32_t a, uint32_t b, uint32_t c, uint32_t d, uint32_t u,
                                   uint32_t v)
{
    uint32_t color = blended(a << 8 >> 24, b << 8 >> 24, c << 8 >> 24, d << 8 >> 24, u, v) << 16;
    QTRI_OPAQUE(color)
    color |= blended(a << 16 >> 24, b << 16 >> 24, c << 16 >> 24, d << 16 >> 24, u, v) << 8;
    QTRI_OPAQUE(color)
    return color | blended(a << 24 >> 24, b << 24 >> 24, c << 24 >> 24, d << 24 >> 24, u, v);
}

static inline uint32_t blended_565(uint32_t a, uint32_t b, uint32_t c, uint32_t d, uint32_t u,
                                   uint32_t v)
{
    uint32_t color = blended(a << 16 >> 27, b << 16 >> 27, c << 16 >> 27, d << 16 >> 27, u, v)
                     << 11;
    QTRI_OPAQUE(color)
    color |= blended(a << 21 >> 26, b << 21 >> 26, c << 21 >> 26, d << 21 >> 26, u, v) << 5;
    QTRI_OPAQUE(color)
    return color | blended(a << 27 >> 27, b << 27 >> 27, c << 27 >> 27, d << 27 >> 27, u, v);
}

/*
 * Texels that equal the key are neither drawn nor seen through the filter: the nearest of the four
 * decides whether the pixel is, and stands in for the others that equal the key.
 */
static bool replace_keys(const qtri_texture *texture, uint32_t tap[4], uint32_t u, uint32_t v)
{
    const uint32_t mask = texture->format->key_mask;
    const uint32_t key = texture->key & mask;
    const uint32_t nearest = tap[(v >> 10) * 2 + (u >> 10)];
    for (int i = 0; i < 4; i++) {
        tap[i] = (tap[i] & mask) == key ? nearest : tap[i];
    }
    return (nearest & mask) == key;
}

/* Where keys are, in taps of `count` pixels: the mask of pixels that are drawn. */
static uint32_t without_keys(const qtri_texture *texture, uint32_t *tap, const uint32_t *weights,
                             int32_t count)
{
    uint32_t drawn = 0;
    for (int32_t i = 0; i < count; i++) {
        uint32_t four[4];
        for (int k = 0; k < 4; k++) {
            four[k] = tap[k * count + i];
        }
        drawn = 2 * drawn + !replace_keys(texture, four, weights[i] & 2047, weights[i] >> 16);
        for (int k = 0; k < 4; k++) {
            tap[k * count + i] = four[k];
        }
    }
    return drawn;
}

/* The numbers of four texels a pixel: all first ones, all second ones, ...; and their weights. */
static void find_taps(uint32_t *tap, uint32_t *weights, const qtri_texel_axis axis[2],
                      const uint32_t *u, const uint32_t *v, int32_t count)
{
    int32_t i = 0;
    do {
        const taps along = taps_at(&axis[0], u[i]);
        const taps across = taps_at(&axis[1], v[i]);
        const uint32_t above = across.index[0] << axis[0].side_log2;
        const uint32_t below = across.index[1] << axis[0].side_log2;
        tap[i] = above + along.index[0];
        tap[count + i] = above + along.index[1];
        tap[2 * count + i] = below + along.index[0];
        tap[3 * count + i] = below + along.index[1];
        weights[i] = across.weight << 16 | along.weight;
    } while (++i < count);
}

/* The same where coordinates fill 32 bits: those of texel_copy.h. */
static void find_repeated_taps(uint32_t *tap, uint32_t *weights, const qtri_texture *texture,
                               const uint32_t *u, const uint32_t *v, int32_t count)
{
    const uint32_t width_log2 = texture->width_log2;
    const uint32_t width = (uint32_t)1 << width_log2;
    const uint32_t rows = (((uint32_t)1 << texture->height_log2) - 1) << width_log2;
    const uint32_t *end = u + count;
    const int32_t second = count;
    do {
        const uint32_t x = *u - (0x80000000u >> width_log2);
        const uint32_t y = *v++ - (width << 15);
        const uint32_t left = x >> (32 - width_log2);
        const uint32_t right = (left + 1) & (width - 1);
        const uint32_t above = y >> 16 & rows;
        const uint32_t below = ((y >> 16) + width) & rows;
        tap[0] = above + left;
        tap[second] = above + right;
        tap[2 * second] = below + left;
        tap[3 * second] = below + right;
        tap++;
        *weights++ = y << (16 - width_log2) >> 21 << 16 | x << width_log2 >> 21;
    } while (++u != end);
}

QTRI_NOINLINE static void blend(uint32_t *color, const uint32_t *tap, const uint32_t *weights,
                                int32_t count)
{
    for (const uint32_t *end = tap + count; tap != end; tap++) {
        const uint32_t along = *weights & 2047;
        const uint32_t across = *weights++ >> 16;
        *color++ = blended_888(tap[0], tap[count], tap[2 * count], tap[3 * count], along, across);
    }
}

QTRI_NOINLINE static void blend_565(uint32_t *color, const uint32_t *tap, const uint32_t *weights,
                                    int32_t count)
{
    for (const uint32_t *end = tap + count; tap != end; tap++) {
        const uint32_t along = *weights & 2047;
        const uint32_t across = *weights++ >> 16;
        *color++ = blended_565(tap[0], tap[count], tap[2 * count], tap[3 * count], along, across);
    }
}

/* Up to TOGETHER pixels of any format. Returns the mask of those that are drawn. */
static uint32_t sample_some(const qtri_raster *raster, const qtri_texel_axis axis[2], uint32_t *u,
                            const uint32_t *v, int32_t count)
{
    const qtri_texture *texture = raster->texture;
    uint32_t tap[4 * TOGETHER];
    uint32_t weights[TOGETHER];
    uint32_t drawn = qtri_mask_of(count);
    if (raster->repeated) {
        find_repeated_taps(tap, weights, texture, u, v, count);
    } else {
        find_taps(tap, weights, axis, u, v, count);
    }
    texture->format->fetch(tap, texture, 4 * count);
    if (texture->has_key) {
        drawn = without_keys(texture, tap, weights, count);
    }
    if (texture->format->decode != NULL) {
        texture->format->decode(tap, texture, 4 * count);
    }
    if (raster->widen != NULL) {
        raster->widen(tap, 4 * count);
    }
    (raster->working == &qtri_colors_565 ? blend_565 : blend)(u, tap, weights, count);
    return drawn;
}

/*
 * Texels of RGB565 that repeat, without a key, as most are, are read where they are. `above` and
 * `below` hold the left texel in the low half and the right one in the high half, so that a channel
 * of either is two shifts.
 */
#define CHANNEL(out, left_up, right_up, down)                                                      \
    {                                                                                              \
        uint32_t left = above << (left_up) >> (down);                                              \
        uint32_t right = above << (right_up) >> (down);                                            \
        const uint32_t top = (left << 11) + (right - left) * u_weight;                             \
        left = below << (left_up) >> (down);                                                       \
        right = below << (right_up) >> (down);                                                     \
        const uint32_t bottom = (left << 11) + (right - left) * u_weight;                          \
        (out) = (top << 11) + (bottom - top) * v_weight;                                           \
        QTRI_OPAQUE(out)                                                                           \
    }

#define SAMPLE_565(name, RED, GREEN, BLUE)                                                         \
    QTRI_NOINLINE static void name(const qtri_texture *texture, uint32_t *u, const uint32_t *v,    \
                                   int32_t count)                                                  \
    {                                                                                              \
        const uint16_t *texels = texture->texels;                                                  \
        uint32_t width_log2 = texture->width_log2;                                                 \
        const uint32_t width = (uint32_t)1 << width_log2;                                          \
        const uint32_t rows = (((uint32_t)1 << texture->height_log2) - 1) << width_log2;           \
        const uint32_t *end = u + count;                                                           \
        do {                                                                                       \
            uint32_t above, below, u_weight, v_weight;                                             \
            {                                                                                      \
                const uint32_t x = (*u << width_log2) - 0x80000000u;                               \
                const uint32_t left = (*u - (0x80000000u >> width_log2)) >> (32 - width_log2);     \
                const uint32_t right = (left + 1) & (width - 1);                                   \
                const uint32_t y = *v++ - (width << 15);                                           \
                const uint16_t *row = texels + (y >> 16 & rows);                                   \
                above = row[left] | (uint32_t)row[right] << 16;                                    \
                row = texels + (((y >> 16) + width) & rows);                                       \
                below = row[left] | (uint32_t)row[right] << 16;                                    \
                u_weight = x >> 21;                                                                \
                v_weight = y << (16 - width_log2) >> 21;                                           \
                QTRI_OPAQUE(above)                                                                 \
                QTRI_OPAQUE(below)                                                                 \
            }                                                                                      \
            uint32_t channel;                                                                      \
            uint32_t color;                                                                        \
            CHANNEL(channel, 16, 0, 27)                                                            \
            color = RED(channel);                                                                  \
            CHANNEL(channel, 21, 5, 26)                                                            \
            color |= GREEN(channel);                                                               \
            CHANNEL(channel, 27, 11, 27)                                                           \
            color |= BLUE(channel);                                                                \
            *u++ = color;                                                                          \
        } while (u != end);                                                                        \
    }

#define RED_565(x)   ((x) + 0x200000u) >> 22 << 11
#define GREEN_565(x) ((x) + 0x200000u) >> 22 << 5
#define BLUE_565(x)  ((x) + 0x200000u) >> 22
SAMPLE_565(sample_565, RED_565, GREEN_565, BLUE_565)

/* 255 / 31 and 255 / 63 of 11 bits of the sum's fraction: .01 of a step besides the rounding. */
#define RED_888(x)   (((x) >> 11) * 8423u + 0x100000u) >> 21 << 16
#define GREEN_888(x) (((x) >> 12) * 4145u + 0x80000u) >> 20 << 8
#define BLUE_888(x)  (((x) >> 11) * 8423u + 0x100000u) >> 21
SAMPLE_565(sample_565_to_888, RED_888, GREEN_888, BLUE_888)

static uint32_t sample(const qtri_raster *raster, const qtri_texel_axis axis[2], uint32_t *u,
                       const uint32_t *v, int32_t count)
{
    const qtri_texture *texture = raster->texture;
    uint32_t drawn = 0;
    if (raster->repeated && texture->format == &qtri_texel_rgb565 && !texture->has_key) {
        (raster->working == &qtri_colors_565 ? sample_565 : sample_565_to_888)(texture, u, v,
                                                                               count);
        return qtri_mask_of(count);
    }
    for (;;) {
        const int32_t some = count < TOGETHER ? count : TOGETHER;
        drawn = drawn << some | sample_some(raster, axis, u, v, some);
        count -= some;
        if (count == 0) {
            return drawn;
        }
        u += some;
        v += some;
    }
}

const qtri_filter qtri_bilinear = {sample};
