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

static inline uint32_t blended_888(const uint32_t tap[4], uint32_t u, uint32_t v)
{
    uint32_t color = 0;
    for (int shift = 0; shift < 24; shift += 8) {
        color |= blended(tap[0] >> shift & 255, tap[1] >> shift & 255, tap[2] >> shift & 255,
                         tap[3] >> shift & 255, u, v)
                 << shift;
    }
    return color;
}

static inline uint32_t blended_565(const uint32_t tap[4], uint32_t u, uint32_t v)
{
    uint32_t color = 0;
    color |= blended(tap[0] & 31, tap[1] & 31, tap[2] & 31, tap[3] & 31, u, v);
    color |= blended(tap[0] >> 5 & 63, tap[1] >> 5 & 63, tap[2] >> 5 & 63, tap[3] >> 5 & 63, u, v)
             << 5;
    color |= blended(tap[0] >> 11, tap[1] >> 11, tap[2] >> 11, tap[3] >> 11, u, v) << 11;
    return color;
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

/* Up to TOGETHER pixels of any format. Returns the mask of those that are drawn. */
static uint32_t sample_some(const qtri_raster *raster, const qtri_texel_axis axis[2], uint32_t *u,
                            const uint32_t *v, int32_t count)
{
    const qtri_texture *texture = raster->texture;
    const bool narrow = raster->working == &qtri_colors_565;
    uint32_t tap[4][TOGETHER];
    uint32_t weights[TOGETHER];
    uint32_t drawn = qtri_mask_of(count);
    for (int32_t i = 0; i < count; i++) {
        const taps along = taps_at(&axis[0], u[i]);
        const taps across = taps_at(&axis[1], v[i]);
        for (int k = 0; k < 4; k++) {
            tap[k][i] = (across.index[k >> 1] << axis[0].side_log2) + along.index[k & 1];
        }
        weights[i] = across.weight << 16 | along.weight;
    }
    for (int k = 0; k < 4; k++) {
        for (int32_t i = count; (i & 3) != 0; i++) {
            tap[k][i] = 0;
        }
        texture->format->fetch(tap[k], texture, count);
    }
    if (texture->has_key) {
        for (int32_t i = 0; i < count; i++) {
            uint32_t four[4] = {tap[0][i], tap[1][i], tap[2][i], tap[3][i]};
            if (replace_keys(texture, four, weights[i] & 2047, weights[i] >> 16)) {
                drawn &= ~((uint32_t)1 << (count - 1 - i));
            }
            for (int k = 0; k < 4; k++) {
                tap[k][i] = four[k];
            }
        }
    }
    for (int k = 0; k < 4; k++) {
        if (texture->format->decode != NULL) {
            texture->format->decode(tap[k], texture, count);
        }
        if (raster->widen != NULL) {
            raster->widen(tap[k], count);
        }
    }
    for (int32_t i = 0; i < count; i++) {
        const uint32_t four[4] = {tap[0][i], tap[1][i], tap[2][i], tap[3][i]};
        const uint32_t along = weights[i] & 2047;
        const uint32_t across = weights[i] >> 16;
        u[i] = narrow ? blended_565(four, along, across) : blended_888(four, along, across);
    }
    return drawn;
}

static uint32_t sample(const qtri_raster *raster, const qtri_texel_axis axis[2], uint32_t *u,
                       const uint32_t *v, int32_t count)
{
    uint32_t drawn = 0;
    for (;;) {
        const int32_t some = count < TOGETHER ? count : TOGETHER;
        drawn = drawn << (some & 31) | sample_some(raster, axis, u, v, some);
        count -= some;
        if (count == 0) {
            return drawn;
        }
        u += some;
        v += some;
    }
}

const qtri_filter qtri_bilinear = {sample};
