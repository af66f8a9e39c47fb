/* SPDX-License-Identifier: MIT */
#include "stage_color.h"

#include "../frame/curves.h"
#include "loop.h"
#include "words.h"

#define MOVE(n)                                                                                    \
    shade += (n);                                                                                  \
    QTRI_OPAQUE(shade)

/*
 * A ramp's half of 2^-16 is 8 units of 2^-10 of a share: the half that rounds here takes its place.
 */
void qtri_shade_light(uint32_t *shade, const qtri_curve *share, int32_t count)
{
    uint32_t at = share->at - 0x8000u + ((uint32_t)1 << 11);
    uint32_t step = share->step;
    const uint32_t bend = share->bend;
#define ONE(i)                                                                                     \
    shade[i] = at >> 12;                                                                           \
    at += step;                                                                                    \
    step += bend;                                                                                  \
    QTRI_OPAQUE(at)
    QTRI_WORDS(count)
#undef ONE
}

#define QTRI_STRAIGHT_SHADES(i)                                                                    \
    shade[i] = r >> 14 << QTRI_SHADE_RED | g >> 14 << QTRI_SHADE_GREEN | b >> 14;                  \
    QTRI_STEP_THREE

#define QTRI_CURVED_SHADES(i) QTRI_STRAIGHT_SHADES(i) QTRI_BEND_THREE

void qtri_shade_rgb(uint32_t *shade, const qtri_curve channel[3], int32_t count)
{
    QTRI_THREE_CURVES(shade, channel, QTRI_SHADE_LESS, count, SHADES)
}

#undef MOVE
#define MOVE(n)                                                                                    \
    color += (n);                                                                                  \
    shade += (n);                                                                                  \
    QTRI_OPAQUE(color)                                                                             \
    QTRI_OPAQUE(shade)

/* Red and blue in lanes of 16 bits: 31 1024 + 512 < 2^15. */
void qtri_light_565(uint32_t *color, const uint32_t *shade, int32_t count)
{
    uint32_t lanes = 0x001F001Fu;
    uint32_t half = 0x02000200u;
    QTRI_OPAQUE(lanes)
#define ONE(i)                                                                                     \
    {                                                                                              \
        const uint32_t pixel = color[i];                                                           \
        const uint32_t light = shade[i];                                                           \
        uint32_t green = (pixel << 21 >> 26) * light + 512u;                                       \
        uint32_t both = ((pixel | pixel << 5) & lanes) * light + half;                             \
        both = both >> 10 & lanes;                                                                 \
        color[i] = both | both >> 5 | green >> 10 << 5;                                            \
        QTRI_ASIDE(half)                                                                           \
    }
    QTRI_WORDS(count)
#undef ONE
}

void qtri_light_888(uint32_t *color, const uint32_t *shade, int32_t count)
{
    uint32_t half = 512;
#define ONE(i)                                                                                     \
    {                                                                                              \
        const uint32_t pixel = color[i];                                                           \
        const uint32_t light = shade[i];                                                           \
        const uint32_t red = (pixel << 8 >> 24) * light + half;                                    \
        const uint32_t green = (pixel << 16 >> 24) * light + half;                                 \
        const uint32_t blue = (pixel << 24 >> 24) * light + half;                                  \
        color[i] = red >> 10 << 16 | green >> 10 << 8 | blue >> 10;                                \
        QTRI_ASIDE(half)                                                                           \
    }
    QTRI_WORDS(count)
#undef ONE
}

/* c light tint: 63 2^10 2^10 < 2^26, 255 2^10 2^10 < 2^28. */
#define TINTED(c, by) (((c)*light * (by) + half) >> 20)

void qtri_tint_565(uint32_t *color, const uint32_t *shade, const uint32_t tint_q10[3],
                   int32_t count)
{
    uint32_t r = tint_q10[0];
    uint32_t g = tint_q10[1];
    uint32_t b = tint_q10[2];
    uint32_t half = (uint32_t)1 << 19;
#define ONE(i)                                                                                     \
    {                                                                                              \
        const uint32_t pixel = color[i];                                                           \
        const uint32_t light = shade[i];                                                           \
        color[i] = TINTED(pixel << 16 >> 27, r) << 11 | TINTED(pixel << 21 >> 26, g) << 5 |        \
                   TINTED(pixel << 27 >> 27, b);                                                   \
        QTRI_ASIDE(r)                                                                              \
        QTRI_ASIDE(g)                                                                              \
        QTRI_ASIDE(b)                                                                              \
        QTRI_ASIDE(half)                                                                           \
    }
    QTRI_WORDS(count)
#undef ONE
}

void qtri_tint_888(uint32_t *color, const uint32_t *shade, const uint32_t tint_q10[3],
                   int32_t count)
{
    uint32_t r = tint_q10[0];
    uint32_t g = tint_q10[1];
    uint32_t b = tint_q10[2];
    uint32_t half = (uint32_t)1 << 19;
#define ONE(i)                                                                                     \
    {                                                                                              \
        const uint32_t pixel = color[i];                                                           \
        const uint32_t light = shade[i];                                                           \
        color[i] = TINTED(pixel << 8 >> 24, r) << 16 | TINTED(pixel << 16 >> 24, g) << 8 |         \
                   TINTED(pixel << 24 >> 24, b);                                                   \
        QTRI_ASIDE(r)                                                                              \
        QTRI_ASIDE(g)                                                                              \
        QTRI_ASIDE(b)                                                                              \
        QTRI_ASIDE(half)                                                                           \
    }
    QTRI_WORDS(count)
#undef ONE
}

/*
 * A channel of p steps times f of 1020 is p f / 1024 and up to p / 256 more: half of that is added
 * for good. So it is off by 63 / 512 at most for that, by 63 / 2040 for f, and by 1/2.
 */
void qtri_times_565(uint32_t *color, const uint32_t *shade, int32_t count)
{
    uint32_t half = 512 + 126;
#define ONE(i)                                                                                     \
    {                                                                                              \
        const uint32_t pixel = color[i];                                                           \
        const uint32_t by = shade[i];                                                              \
        const uint32_t red = (pixel << 16 >> 27) * (by >> QTRI_SHADE_RED) + half;                  \
        const uint32_t green = (pixel << 21 >> 26) * (by << 12 >> 22) + half;                      \
        const uint32_t blue = (pixel << 27 >> 27) * (by << 22 >> 22) + half;                       \
        color[i] = red >> 10 << 11 | green >> 10 << 5 | blue >> 10;                                \
        QTRI_ASIDE(half)                                                                           \
    }
    QTRI_WORDS(count)
#undef ONE
}

/* Here f is taken to 1023 first: p / 1024 is missing then, half of which is added. */
void qtri_times_888(uint32_t *color, const uint32_t *shade, int32_t count)
{
    uint32_t half = 512 + 128;
#define ONE(i)                                                                                     \
    {                                                                                              \
        const uint32_t pixel = color[i];                                                           \
        const uint32_t by = shade[i];                                                              \
        uint32_t red = by >> QTRI_SHADE_RED;                                                       \
        uint32_t green = by << 12 >> 22;                                                           \
        uint32_t blue = by << 22 >> 22;                                                            \
        red = (pixel << 8 >> 24) * (red + (red >> 8)) + half;                                      \
        green = (pixel << 16 >> 24) * (green + (green >> 8)) + half;                               \
        blue = (pixel << 24 >> 24) * (blue + (blue >> 8)) + half;                                  \
        color[i] = red >> 10 << 16 | green >> 10 << 8 | blue >> 10;                                \
        QTRI_ASIDE(half)                                                                           \
    }
    QTRI_WORDS(count)
#undef ONE
}

#undef MOVE
#define MOVE(n)                                                                                    \
    color += (n);                                                                                  \
    QTRI_OPAQUE(color)

/* (255 x + 15) / 31 and (255 x + 31) / 63 for all x; red and blue in lanes: 31 527 + 23 < 2^14. */
void qtri_565_to_888(uint32_t *color, int32_t count)
{
    uint32_t lanes = 0x001F001Fu;
    uint32_t both_ways = 0x00FF00FFu;
    uint32_t five = 527;
    uint32_t half = 0x00170017u;
    uint32_t six = 259 * 4;
    uint32_t half_six = 33 * 4;
    QTRI_OPAQUE(both_ways)
    QTRI_OPAQUE(five)
    QTRI_OPAQUE(half)
    QTRI_OPAQUE(six)
    QTRI_OPAQUE(half_six)
#define ONE(i)                                                                                     \
    {                                                                                              \
        const uint32_t pixel = color[i];                                                           \
        uint32_t both = ((pixel | pixel << 5) & lanes) * five + half;                              \
        both = both >> 6 & both_ways;                                                              \
        const uint32_t green = (pixel << 21 >> 26) * six + half_six;                               \
        color[i] = both | green >> 8 << 8;                                                         \
        QTRI_ASIDE(lanes)                                                                          \
        QTRI_ASIDE(both_ways)                                                                      \
        QTRI_ASIDE(five)                                                                           \
        QTRI_ASIDE(half)                                                                           \
        QTRI_ASIDE(six)                                                                            \
    }
    QTRI_WORDS(count)
#undef ONE
}

/*
 * 249/2048 of 255 is 31 and .004 more, 253/1024 is 63 and .003 more: red and blue in lanes, of
 * 255 249 + 1024 < 2^16.
 */
void qtri_888_to_565(uint32_t *color, int32_t count)
{
    uint32_t bytes = 0x00FF00FFu;
    uint32_t five = 249;
    uint32_t six = 253;
    uint32_t half = 0x04000400u;
    uint32_t lanes = 0x001F001Fu;
    QTRI_OPAQUE(five)
    QTRI_OPAQUE(six)
    QTRI_OPAQUE(half)
    QTRI_OPAQUE(lanes)
#define ONE(i)                                                                                     \
    {                                                                                              \
        const uint32_t pixel = color[i];                                                           \
        uint32_t both = (pixel & bytes) * five + half;                                             \
        both = both >> 11 & lanes;                                                                 \
        const uint32_t green = (pixel << 16 >> 24) * six + 512;                                    \
        color[i] = both | both >> 5 | green >> 10 << 5;                                            \
        QTRI_ASIDE(bytes)                                                                          \
        QTRI_ASIDE(half)                                                                           \
        QTRI_ASIDE(lanes)                                                                          \
    }
    QTRI_WORDS(count)
#undef ONE
}

/* What light of 1 makes of it. */
void qtri_888_to_gray(uint32_t *color, int32_t count)
{
    uint32_t r = QTRI_LUMA_RED;
    uint32_t g = QTRI_LUMA_GREEN;
    uint32_t b = QTRI_LUMA_BLUE;
    uint32_t half = (uint32_t)1 << 13;
    QTRI_OPAQUE(half)
#define ONE(i)                                                                                     \
    {                                                                                              \
        const uint32_t pixel = color[i];                                                           \
        color[i] =                                                                                 \
            ((pixel << 8 >> 24) * r + (pixel << 16 >> 24) * g + (pixel << 24 >> 24) * b + half) >> \
            14;                                                                                    \
        QTRI_ASIDE(r)                                                                              \
        QTRI_ASIDE(g)                                                                              \
        QTRI_ASIDE(b)                                                                              \
        QTRI_ASIDE(half)                                                                           \
    }
    QTRI_WORDS(count)
#undef ONE
}

/* Of 2^16, of 255 in 31 and in 63 steps. */
void qtri_565_to_gray(uint32_t *color, int32_t count)
{
    uint32_t r = 161187;
    uint32_t g = 155710;
    uint32_t b = 61456;
    uint32_t half = 0x8000u;
    QTRI_OPAQUE(half)
#define ONE(i)                                                                                     \
    {                                                                                              \
        const uint32_t pixel = color[i];                                                           \
        color[i] = ((pixel << 16 >> 27) * r + (pixel << 21 >> 26) * g + (pixel << 27 >> 27) * b +  \
                    half) >>                                                                       \
                   16;                                                                             \
        QTRI_ASIDE(r)                                                                              \
        QTRI_ASIDE(g)                                                                              \
        QTRI_ASIDE(b)                                                                              \
        QTRI_ASIDE(half)                                                                           \
    }
    QTRI_WORDS(count)
#undef ONE
}

#undef MOVE
#define MOVE(n)                                                                                    \
    color += (n);                                                                                  \
    shade += (n);                                                                                  \
    QTRI_OPAQUE(color)                                                                             \
    QTRI_OPAQUE(shade)

void qtri_tint_gray(uint32_t *color, const uint32_t *shade, const uint32_t tint_q10[3],
                    int32_t count)
{
    uint32_t r = (QTRI_LUMA_RED * tint_q10[0] + 512) >> 10;
    uint32_t g = (QTRI_LUMA_GREEN * tint_q10[1] + 512) >> 10;
    uint32_t b = (QTRI_LUMA_BLUE * tint_q10[2] + 512) >> 10;
    uint32_t half = (uint32_t)1 << 23;
    QTRI_OPAQUE(half)
#define ONE(i)                                                                                     \
    {                                                                                              \
        const uint32_t pixel = color[i];                                                           \
        const uint32_t luma =                                                                      \
            (pixel << 8 >> 24) * r + (pixel << 16 >> 24) * g + (pixel << 24 >> 24) * b;            \
        color[i] = (luma * shade[i] + half) >> 24;                                                 \
        QTRI_ASIDE(r)                                                                              \
        QTRI_ASIDE(g)                                                                              \
        QTRI_ASIDE(b)                                                                              \
        QTRI_ASIDE(half)                                                                           \
    }
    QTRI_WORDS(count)
#undef ONE
}

void qtri_light_gray(uint32_t *color, const uint32_t *shade, int32_t count)
{
    static const uint32_t white_q10[3] = {1024, 1024, 1024};
    qtri_tint_gray(color, shade, white_q10, count);
}

/* Shades of 1020 are 1, 255 1020 2^14 < 2^32; 257/256 of that, which is within 2^-15 of 1024. */
void qtri_times_gray(uint32_t *color, const uint32_t *shade, int32_t count)
{
    uint32_t r = QTRI_LUMA_RED;
    uint32_t g = QTRI_LUMA_GREEN;
    uint32_t b = QTRI_LUMA_BLUE;
#define ONE(i)                                                                                     \
    {                                                                                              \
        const uint32_t pixel = color[i];                                                           \
        const uint32_t by = shade[i];                                                              \
        uint32_t luma = (pixel << 8 >> 24) * r * (by >> QTRI_SHADE_RED);                           \
        luma += (pixel << 16 >> 24) * g * (by << 12 >> 22);                                        \
        luma += (pixel << 24 >> 24) * b * (by << 22 >> 22);                                        \
        luma >>= 14;                                                                               \
        color[i] = (luma + (luma >> 8) + 512) >> 10;                                               \
        QTRI_ASIDE(r)                                                                              \
        QTRI_ASIDE(g)                                                                              \
        QTRI_ASIDE(b)                                                                              \
    }
    QTRI_WORDS(count)
#undef ONE
}

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

#define QTRI_CURVED_TIMES_GRAY(i) QTRI_STRAIGHT_TIMES_GRAY(i) QTRI_BEND_THREE
