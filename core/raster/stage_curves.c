/* SPDX-License-Identifier: MIT */
/*
 * Texels times colours along curves: what qtri_shade_rgb and then times_ make, to the bit, without
 * shades that are put down. In one colour there are loops of their own, for speed.
 */
#include "../frame/curves.h"
#include "loop.h"
#include "stage_color.h"
#include "words.h"

#define MOVE(n)                                                                                    \
    color += (n);                                                                                  \
    QTRI_OPAQUE(color)

static inline bool is_flat(const qtri_curve channel[3])
{
    return !QTRI_SMALL_CODE && (channel[0].step | channel[1].step | channel[2].step |
                                channel[0].bend | channel[1].bend | channel[2].bend) == 0;
}

#define QTRI_STRAIGHT_TIMES_565(i)                                                                 \
    {                                                                                              \
        const uint32_t pixel = color[i];                                                           \
        const uint32_t blue = (pixel << 27 >> 27) * (b >> 14) + half;                              \
        const uint32_t green = (pixel << 21 >> 26) * (g >> 14) + half;                             \
        const uint32_t red = (pixel << 16 >> 27) * (r >> 14) + half;                               \
        color[i] = red >> 10 << 11 | green >> 10 << 5 | blue >> 10;                                \
    }                                                                                              \
    QTRI_STEP_THREE

#define QTRI_STRAIGHT_TIMES_888(i)                                                                 \
    {                                                                                              \
        const uint32_t pixel = color[i];                                                           \
        const uint32_t blue = (pixel << 24 >> 24) * ((b >> 14) + (b >> 22)) + half;                \
        const uint32_t green = (pixel << 16 >> 24) * ((g >> 14) + (g >> 22)) + half;               \
        const uint32_t red = (pixel << 8 >> 24) * ((r >> 14) + (r >> 22)) + half;                  \
        color[i] = red >> 10 << 16 | green >> 10 << 8 | blue >> 10;                                \
    }                                                                                              \
    QTRI_STEP_THREE

#define QTRI_STRAIGHT_TIMES_GRAY(i)                                                                \
    {                                                                                              \
        const uint32_t pixel = color[i];                                                           \
        uint32_t luma = (pixel << 24 >> 24) * QTRI_LUMA_BLUE * (b >> 14);                          \
        luma += (pixel << 16 >> 24) * QTRI_LUMA_GREEN * (g >> 14);                                 \
        luma += (pixel << 8 >> 24) * QTRI_LUMA_RED * (r >> 14);                                    \
        luma >>= 14;                                                                               \
        color[i] = (luma + (luma >> 8) + 512) >> 10;                                               \
    }                                                                                              \
    QTRI_STEP_THREE

#define QTRI_CURVED_TIMES_565(i)  QTRI_STRAIGHT_TIMES_565(i) QTRI_BEND_THREE
#define QTRI_CURVED_TIMES_888(i)  QTRI_STRAIGHT_TIMES_888(i) QTRI_BEND_THREE
#define QTRI_CURVED_TIMES_GRAY(i) QTRI_STRAIGHT_TIMES_GRAY(i) QTRI_BEND_THREE

static void flat_565(uint32_t *color, const qtri_curve channel[3], int32_t count)
{
    uint32_t r = (channel[0].at - QTRI_SHADE_LESS) >> 14;
    uint32_t g = (channel[1].at - QTRI_SHADE_LESS) >> 14;
    uint32_t b = (channel[2].at - QTRI_SHADE_LESS) >> 14;
    uint32_t half = 512 + 126;
    QTRI_OPAQUE(half)
#define ONE(i)                                                                                     \
    {                                                                                              \
        const uint32_t pixel = color[i];                                                           \
        const uint32_t red = (pixel << 16 >> 27) * r + half;                                       \
        const uint32_t green = (pixel << 21 >> 26) * g + half;                                     \
        const uint32_t blue = (pixel << 27 >> 27) * b + half;                                      \
        color[i] = red >> 10 << 11 | green >> 10 << 5 | blue >> 10;                                \
        QTRI_ASIDE(r)                                                                              \
        QTRI_ASIDE(g)                                                                              \
        QTRI_ASIDE(b)                                                                              \
        QTRI_ASIDE(half)                                                                           \
    }
    QTRI_WORDS(count)
#undef ONE
}

void qtri_times_curves_565(uint32_t *color, const qtri_curve channel[3], int32_t count)
{
    if (is_flat(channel)) {
        flat_565(color, channel, count);
        return;
    }
    uint32_t half = 512 + 126;
    QTRI_OPAQUE(half)
    QTRI_THREE_CURVES(color, channel, QTRI_SHADE_LESS, count, TIMES_565)
}

static void flat_888(uint32_t *color, const qtri_curve channel[3], int32_t count)
{
    uint32_t r = (channel[0].at - QTRI_SHADE_LESS) >> 14;
    uint32_t g = (channel[1].at - QTRI_SHADE_LESS) >> 14;
    uint32_t b = (channel[2].at - QTRI_SHADE_LESS) >> 14;
    uint32_t half = 512 + 128;
    r += r >> 8;
    g += g >> 8;
    b += b >> 8;
    QTRI_OPAQUE(half)
#define ONE(i)                                                                                     \
    {                                                                                              \
        const uint32_t pixel = color[i];                                                           \
        const uint32_t red = (pixel << 8 >> 24) * r + half;                                        \
        const uint32_t green = (pixel << 16 >> 24) * g + half;                                     \
        const uint32_t blue = (pixel << 24 >> 24) * b + half;                                      \
        color[i] = red >> 10 << 16 | green >> 10 << 8 | blue >> 10;                                \
        QTRI_ASIDE(r)                                                                              \
        QTRI_ASIDE(g)                                                                              \
        QTRI_ASIDE(b)                                                                              \
        QTRI_ASIDE(half)                                                                           \
    }
    QTRI_WORDS(count)
#undef ONE
}

void qtri_times_curves_888(uint32_t *color, const qtri_curve channel[3], int32_t count)
{
    if (is_flat(channel)) {
        flat_888(color, channel, count);
        return;
    }
    uint32_t half = 512 + 128;
    QTRI_OPAQUE(half)
    QTRI_THREE_CURVES(color, channel, QTRI_SHADE_LESS, count, TIMES_888)
}

static void flat_gray(uint32_t *color, const qtri_curve channel[3], int32_t count)
{
    uint32_t r = ((channel[0].at - QTRI_SHADE_LESS) >> 14) * QTRI_LUMA_RED;
    uint32_t g = ((channel[1].at - QTRI_SHADE_LESS) >> 14) * QTRI_LUMA_GREEN;
    uint32_t b = ((channel[2].at - QTRI_SHADE_LESS) >> 14) * QTRI_LUMA_BLUE;
#define ONE(i)                                                                                     \
    {                                                                                              \
        const uint32_t pixel = color[i];                                                           \
        uint32_t luma =                                                                            \
            (pixel << 8 >> 24) * r + (pixel << 16 >> 24) * g + (pixel << 24 >> 24) * b;            \
        luma >>= 14;                                                                               \
        color[i] = (luma + (luma >> 8) + 512) >> 10;                                               \
        QTRI_ASIDE(r)                                                                              \
        QTRI_ASIDE(g)                                                                              \
        QTRI_ASIDE(b)                                                                              \
    }
    QTRI_WORDS(count)
#undef ONE
}

void qtri_times_curves_gray(uint32_t *color, const qtri_curve channel[3], int32_t count)
{
    if (is_flat(channel)) {
        flat_gray(color, channel, count);
        return;
    }
    QTRI_THREE_CURVES(color, channel, QTRI_SHADE_LESS, count, TIMES_GRAY)
}
