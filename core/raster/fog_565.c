/* SPDX-License-Identifier: MIT */
#include "fog_565.h"

#include "../frame/barrier.h"
#include "../frame/curves.h"
#include "effect.h"
#include "stage_color.h"

static uint32_t pack(const int32_t channel[3])
{
    return qtri_pack_888(channel);
}

#define QTRI_CURVED_FINER(i)                                                                       \
    color[i] = r >> 16 << 16 | g >> 16 << 8 | b >> 16;                                             \
    QTRI_STEP_THREE                                                                                \
    QTRI_BEND_THREE

/* A step n.16 of 2^-8, rounded. */
static inline uint32_t short_step(uint32_t step)
{
    return (uint32_t)((int32_t)(step + 0x80) >> 8);
}

/*
 * Straight ones, as most are, are red and blue in one word and green in another, with 8 bits after
 * the point: cut off to 2^-8, and after 32 steps off by 2^-4 more, 1/128 of a step of RGB565. That
 * is less than the half that is in them, so that none reaches into another.
 */
static void smooth(uint32_t *color, const qtri_curve *c, int32_t count)
{
    if ((c[0].bend | c[1].bend | c[2].bend) != 0) {
        QTRI_CURVED_CURVES(color, c, 0, count, FINER)
        return;
    }
    uint32_t both = (c[0].at >> 8 << 16) + (uint32_t)((int32_t)c[2].at >> 8);
    uint32_t green = c[1].at >> 8;
    uint32_t step = (short_step(c[0].step) << 16) + short_step(c[2].step);
    uint32_t green_step = short_step(c[1].step);
    uint32_t bytes = 0x00FF00FFu;
    uint32_t green_byte = 0xFF00u;
    QTRI_OPAQUE(bytes)
    QTRI_OPAQUE(green_byte)
#define ONE(i)                                                                                     \
    color[i] = (both >> 8 & bytes) | (green & green_byte);                                         \
    both += step;                                                                                  \
    green += green_step;                                                                           \
    QTRI_OPAQUE(both)                                                                              \
    QTRI_OPAQUE(green)                                                                             \
    QTRI_ASIDE(step)                                                                               \
    QTRI_ASIDE(green_step)
    QTRI_CURVE_WORDS(color, count, ONE)
#undef ONE
}

#define FIVE ((int32_t)248 << 16)
#define SIX  ((int32_t)252 << 16)

/* 248/255 and 252/255 in Q30, rounded. */
const qtri_colors qtri_colors_565_finer = {
    {FIVE, SIX, FIVE}, {1044266558u, 1061109567u, 1044266558u}, false, 16, 8, 10, 3, pack, smooth};

/* 249/256 of 255 is 248 and .03 more, 253/256 is 252 and .01 more. */
void qtri_888_to_565_finer(uint32_t *color, int32_t count)
{
    QTRI_EACH_WORD(color, count, c,
                   (((c & 0x00FF00FFu) * 249 + 0x00800080u) >> 8 & 0x00FF00FFu) |
                       (((c >> 8 & 0xFF) * 253 + 128) & 0xFF00u))
}

void qtri_fog_begin_565(qtri_raster *raster)
{
    const qtri_vertex_blend *by_vertex = qtri_by_vertex(raster);
    if (raster->format->colors != &qtri_colors_565 || raster->wide || raster->samples != NULL ||
        by_vertex != NULL) {
        return;
    }
    if (raster->texture == NULL) {
        raster->units = &qtri_colors_565_finer;
    } else if (raster->narrow == qtri_888_to_565) {
        raster->narrow = qtri_888_to_565_finer;
        raster->convert = qtri_888_to_565_finer;
    } else {
        return;
    }
    raster->finer = true;
}

/*
 * fog + (color - fog) share, and half a step: red and blue 16 bits apart, in shares of 256, 248 256
 * + 1024 < 2^16, with eighths 11 bits from their step; green, which has twice the steps, in shares
 * of 1024, its quarters, 8 bits up, 20 bits from their step.
 */
typedef struct mix {
    uint32_t bytes, fives;
    uint32_t less, green_less; /* the fog's */
    uint32_t more, green_more; /* all of it, with the half that rounds */
} mix;

static inline mix mix_of(uint32_t fog, uint32_t half, uint32_t green_half)
{
    const uint32_t both = fog & 0x00FF00FFu;
    const uint32_t green = fog & 0xFF00u;
    const mix m = {0x00FF00FFu, 0x001F001Fu,       0 - both,
                   0 - green,   both * 256 + half, green * 1024 + green_half};
    return m;
}

/* One colour in its share, `both` sums and that of `green`, to be PUT. */
#define ONE(i)                                                                                     \
    {                                                                                              \
        uint32_t green = color[i];                                                                 \
        uint32_t k = share[i];                                                                     \
        uint32_t both = green & m.bytes;                                                           \
        green = (green - both + m.green_less) * k + m.green_more;                                  \
        k = (k + 2) >> 2;                                                                          \
        QTRI_TOGETHER(green)                                                                       \
        both = (both + m.less) * k + m.more;                                                       \
        QTRI_TOGETHER(both)                                                                        \
        PUT(i)                                                                                     \
        QTRI_OPAQUE(color)                                                                         \
        QTRI_ASIDE(m.less)                                                                         \
        QTRI_ASIDE(m.green_less)                                                                   \
        QTRI_ASIDE(m.more)                                                                         \
        QTRI_ASIDE(m.green_more)                                                                   \
    }
#define WORDS                                                                                      \
    for (const uint32_t *end = color + count; color < end; color += 4, share += 4) {               \
        ONE(0)                                                                                     \
        ONE(1)                                                                                     \
        ONE(2)                                                                                     \
        ONE(3)                                                                                     \
    }

/* NOLINTBEGIN(clang-analyzer-core.*): shares past the end are of spare words */
#define PUT(i)                                                                                     \
    both = both >> 11 & m.fives;                                                                   \
    color[i] = both | both >> 5 | green >> 20 << 5;
void qtri_fog_words_565(uint32_t *color, uint32_t fog, const uint32_t *share, int32_t count)
{
    mix m = mix_of(fog, 0x04000400u, 0x80000u);
    QTRI_OPAQUE(m.bytes)
    QTRI_OPAQUE(m.fives)
    WORDS
}
#undef PUT

#define PUT(i) color[i] = (both >> 8 & m.bytes) | green >> 18 << 8;
void qtri_fog_words_finer(uint32_t *color, uint32_t fog, const uint32_t *share, int32_t count)
{
    mix m = mix_of(fog, 0x00800080u, 0x20000u);
    QTRI_OPAQUE(m.bytes)
    WORDS
}
#undef PUT
/* NOLINTEND(clang-analyzer-core.*) */

#define PUT(i)                                                                                     \
    both = both >> 11 & m.fives;                                                                   \
    pixel[i] = (uint16_t)(both | both >> 5 | green >> 20 << 5);
void qtri_fog_row_565(uint16_t *pixel, const uint32_t *color, uint32_t fog, const uint32_t *share,
                      int32_t count)
{
    mix m = mix_of(fog, 0x04000400u, 0x80000u);
    QTRI_OPAQUE(m.bytes)
    QTRI_OPAQUE(m.fives)
    QTRI_FOG_ROW
}
#undef PUT

#define PUT(i)                                                                                     \
    both = both >> 11 & m.fives;                                                                   \
    uint16_t *const pixel = qtri_placed_16(pixels, pitch, *place++);                               \
    *pixel = (uint16_t)(both | both >> 5 | green >> 20 << 5);
void qtri_fog_list_565(const qtri_raster *raster, const uint32_t *share, int32_t count)
{
    mix m = mix_of(raster->fog->word[3], 0x04000400u, 0x80000u);
    QTRI_FOG_PLACES
    QTRI_OPAQUE(m.bytes)
    QTRI_OPAQUE(m.fives)
    for (; place != end; color++, share++) {
        ONE(0)
    }
}
#undef PUT
#undef ONE

/* color k + under (256 - k) / 256: of pixels, steps are eight eighths and four quarters. */
void qtri_fog_over_565(uint32_t *color, const uint16_t *under, int32_t count, uint32_t alpha)
{
    const uint32_t k = alpha + (alpha >> 7);
    const uint32_t rest = (256 - k) * 8;
    const uint32_t bytes = 0x00FF00FFu;
    const uint32_t fives = 0x001F001Fu;
    for (const uint32_t *end = color + count; color != end; color++) {
        const uint32_t c = *color;
        const uint32_t u = *under++;
        uint32_t both = (c & bytes) * k + ((u | u << 5) & fives) * rest + 0x04000400u;
        const uint32_t green = (c & 0xFF00) * k + (u & 0x07E0) * (4 * rest) + 0x20000u;
        both = both >> 11 & fives;
        *color = both | both >> 5 | green >> 18 << 5;
        QTRI_OPAQUE(color)
    }
}
