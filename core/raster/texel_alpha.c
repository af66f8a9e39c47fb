/* SPDX-License-Identifier: MIT */
/*
 * Formats of texels with alpha. Their colours are 0xAARRGGBB as far as the blend: stages of 8 bits
 * a channel look at the low 24, and those that multiply are followed by what puts alpha back.
 */
#include "qtri/body/state.h"

#include "../bits/reciprocal.h"
#include "list_values.h"
#include "stage_color.h"
#include "texel_format.h"
#include "textured.h"

static bool usable(const qtri_texture *texture)
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

static void fetch_32(uint32_t *texel, const qtri_texture *texture, int32_t count)
{
    const uint32_t *texels = texture->texels;
    QTRI_EACH_WORD(texel, count, number, texels[number])
}

/* Each digit of x becomes two. */
static inline uint32_t widen_4444(uint32_t x)
{
    x = (x & 0xF000) << 12 | (x & 0xF00) << 8 | (x & 0xF0) << 4 | (x & 0xF);
    return x | x << 4;
}

/* 31 becomes 255, rounded between. */
static inline uint32_t widen_1555(uint32_t x)
{
    const uint32_t red = ((x >> 10 & 31) * 527 + 23) >> 6;
    const uint32_t green = ((x >> 5 & 31) * 527 + 23) >> 6;
    const uint32_t blue = ((x & 31) * 527 + 23) >> 6;
    return ((x & 0x8000) != 0 ? 0xFF000000u : 0) | red << 16 | green << 8 | blue;
}

static void decode_4444(uint32_t *texel, const qtri_texture *texture, int32_t count)
{
    (void)texture;
    QTRI_EACH_WORD(texel, count, x, widen_4444(x))
}

static void decode_1555(uint32_t *texel, const qtri_texture *texture, int32_t count)
{
    (void)texture;
    QTRI_EACH_WORD(texel, count, x, widen_1555(x))
}

static void decode_alpha(uint32_t *texel, const qtri_texture *texture, int32_t count)
{
    (void)texture;
    QTRI_EACH_WORD(texel, count, x, x << 24 | 0xFFFFFFu)
}

/* Stages that multiply, with alpha saved before and put back after. */
typedef struct saved {
    uint8_t alpha[QTRI_BATCH];
} saved;

static void save(saved *s, const uint32_t *color, int32_t count)
{
    for (int32_t i = 0; i < count; i++) {
        s->alpha[i] = (uint8_t)(color[i] >> 24);
    }
}

static void put_back(const saved *s, uint32_t *color, int32_t count)
{
    for (int32_t i = 0; i < count; i++) {
        color[i] |= (uint32_t)s->alpha[i] << 24;
    }
}

static void light(uint32_t *color, const uint32_t *shade, int32_t count)
{
    saved s;
    save(&s, color, count);
    qtri_light_888(color, shade, count);
    put_back(&s, color, count);
}

static void times(uint32_t *color, const uint32_t *shade, int32_t count)
{
    saved s;
    save(&s, color, count);
    qtri_times_888(color, shade, count);
    put_back(&s, color, count);
}

static void times_curves(uint32_t *color, const qtri_curve channel[3], int32_t count)
{
    saved s;
    save(&s, color, count);
    qtri_times_curves_888(color, channel, count);
    put_back(&s, color, count);
}

static void tinted(uint32_t *color, const uint32_t *shade, const uint32_t tint_q10[3],
                   int32_t count)
{
    saved s;
    save(&s, color, count);
    qtri_tint_888(color, shade, tint_q10, count);
    put_back(&s, color, count);
}

/* Without a blend. */
static void strip(uint32_t *color, int32_t count)
{
    QTRI_EACH_WORD(color, count, x, x & 0xFFFFFF)
}

/* Filtered: four texels and their shares ------------------------------------------------------- */

/* Shares of a pixel's texels, of their sum, times how opaque they are: 2^30 at most in all. */
typedef struct shares {
    uint32_t of[4], sum;
} shares;

static void set_shares(shares *s, const uint32_t tap[4], uint32_t weight)
{
    const uint32_t along = weight & 2047;
    const uint32_t across = weight >> 16;
    s->of[3] = along * across;
    s->of[1] = (along << 11) - s->of[3];
    s->of[2] = (across << 11) - s->of[3];
    s->of[0] = ((uint32_t)1 << 22) - (along << 11) - s->of[2];
    s->sum = 0;
    for (int i = 0; i < 4; i++) {
        s->of[i] *= tap[i] >> 24;
        s->sum += s->of[i];
    }
}

/*
 * Colours weighted by how opaque they are, so that what is not seen lends no colour. Shares are cut
 * to 16 bits of their sum, which is then divided by as it is: off by .03 of a step of 255, and by
 * .01 for the quotient.
 */
static uint32_t mean_of(const uint32_t tap[4], uint32_t weight)
{
    shares s;
    uint32_t channel[3] = {0, 0, 0};
    uint32_t sum = 0; /* 2^15 - 3 .. 2^16 - 1 */
    set_shares(&s, tap, weight);
    if (s.sum == 0) {
        return 0;
    }
    const int32_t zeros = qtri_clz32(s.sum);
    for (int i = 0; i < 4; i++) {
        const uint32_t share = s.of[i] << zeros >> 16;
        sum += share;
        channel[0] += share * (tap[i] >> 16 & 255);
        channel[1] += share * (tap[i] >> 8 & 255);
        channel[2] += share * (tap[i] & 255);
    }
    const uint32_t odd = sum < 0x8000u;
    const uint32_t inverse = qtri_reciprocal_q31(sum << odd) << (1 + odd); /* 2^32 / sum */
    uint32_t color = (s.sum + ((uint32_t)1 << 21)) >> 22;
    for (int i = 0; i < 3; i++) {
        const uint32_t c_q8 = qtri_mul_high32(channel[i] << 8, inverse); /* 255.5 at most */
        color = color << 8 | (c_q8 + 128) >> 8;
    }
    return color;
}

/* The same of texels that are as opaque as each other. */
static uint32_t plain_mean_of(const uint32_t tap[4], uint32_t weight)
{
    const uint32_t along = weight & 2047;
    const uint32_t across = weight >> 16;
    uint32_t color = tap[0] >> 24;
    for (int shift = 16; shift >= 0; shift -= 8) {
        const uint32_t c[4] = {tap[0] >> shift & 255, tap[1] >> shift & 255, tap[2] >> shift & 255,
                               tap[3] >> shift & 255};
        const uint32_t above = c[0] * (2048 - along) + c[1] * along;
        const uint32_t below = c[2] * (2048 - along) + c[3] * along;
        const uint32_t both = above * (2048 - across) + below * across; /* < 2^30 */
        color = color << 8 | (both + ((uint32_t)1 << 21)) >> 22;
    }
    return color;
}

uint32_t qtri_alpha_mean(const uint32_t texel[4], uint32_t along, uint32_t across)
{
    const uint32_t differ = (texel[0] ^ texel[1]) | (texel[0] ^ texel[2]) | (texel[0] ^ texel[3]);
    const uint32_t weight = across << 16 | along;
    return differ >> 24 == 0 ? plain_mean_of(texel, weight) : mean_of(texel, weight);
}

static void mix_taps(uint32_t *color, const uint32_t *tap, const uint32_t *weight, int32_t count)
{
    for (int32_t i = 0; i < count; i++, tap += 4) {
        const uint32_t differ = (tap[0] ^ tap[1]) | (tap[0] ^ tap[2]) | (tap[0] ^ tap[3]);
        color[i] = differ >> 24 == 0 ? plain_mean_of(tap, weight[i]) : mean_of(tap, weight[i]);
    }
}

static uint32_t enough(const qtri_raster *raster, const uint32_t *color, int32_t count)
{
    const uint32_t least = (uint32_t)raster->least_alpha << 24;
    uint32_t mask = 0;
    for (const uint32_t *end = color + count; color != end; color++) {
        mask = 2 * mask + (*color >= least);
    }
    return mask;
}

static void init(qtri_raster *raster, const qtri_material *material)
{
    qtri_textured_init(raster, material);
    if (material->least_alpha != 0) {
        raster->seen = enough;
    }
    if (raster->blend != NULL || material->least_alpha != 0) {
        raster->mix_taps = mix_taps;
    }
    if (raster->blend != NULL) {
        raster->wide = true;
        raster->gray = false;
        raster->narrow = NULL;
        raster->convert = NULL;
        raster->light = light;
        raster->times = times;
        raster->times_curves = times_curves;
        raster->tinted = tinted;
    } else if (raster->narrow == NULL) {
        raster->narrow = strip;
        raster->convert = strip;
    }
}

static const qtri_texturing stages = {init,
                                      qtri_textured_axes,
                                      qtri_textured_begin_large,
                                      qtri_textured_chunk,
                                      qtri_list_set_texels,
                                      qtri_list_texels,
                                      qtri_list_finish_texels};

const qtri_texel_format qtri_texel_argb4444 = {
    &stages, &qtri_colors_888, 0xFFFF, 0, usable, fetch_16, decode_4444, QTRI_TEXEL_ARGB4444};
const qtri_texel_format qtri_texel_argb1555 = {
    &stages, &qtri_colors_888, 0xFFFF, 0, usable, fetch_16, decode_1555, QTRI_TEXEL_ARGB1555};
const qtri_texel_format qtri_texel_argb8888 = {
    &stages, &qtri_colors_888, UINT32_MAX, 0, usable, fetch_32, NULL, QTRI_TEXEL_ARGB8888};
const qtri_texel_format qtri_texel_alpha8 = {
    &stages, &qtri_colors_888, 0xFF, 0, usable, fetch_8, decode_alpha, QTRI_TEXEL_ALPHA8};
