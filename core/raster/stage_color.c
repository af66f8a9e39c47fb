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
    QTRI_THREE_CURVES(shade, channel, 0x8000u - ((uint32_t)1 << 13), count, SHADES)
}

void qtri_shade_constant(uint32_t *shade, uint32_t value, int32_t count)
{
#define ONE(i) shade[i] = value;
    QTRI_WORDS(count)
#undef ONE
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

void qtri_565_to_888(uint32_t *color, int32_t count)
{
    uint32_t five = 527; /* (255 x + 15) / 31 and (255 x + 31) / 63 for all x */
    uint32_t six = 259;
#define ONE(i)                                                                                     \
    {                                                                                              \
        const uint32_t pixel = color[i];                                                           \
        const uint32_t red = ((pixel << 16 >> 27) * five + 23) >> 6;                               \
        const uint32_t green = ((pixel << 21 >> 26) * six + 33) >> 6;                              \
        const uint32_t blue = ((pixel << 27 >> 27) * five + 23) >> 6;                              \
        color[i] = red << 16 | green << 8 | blue;                                                  \
        QTRI_ASIDE(five)                                                                           \
        QTRI_ASIDE(six)                                                                            \
    }
    QTRI_WORDS(count)
#undef ONE
}

/* 31/255 = 1/8 (1 - 1/32 + ...), 63/255 = 1/4 (1 - 1/64 + ...): red and blue in lanes. */
void qtri_888_to_565(uint32_t *color, int32_t count)
{
#define ONE(i)                                                                                     \
    {                                                                                              \
        const uint32_t pixel = color[i];                                                           \
        uint32_t both = pixel & 0x00FF00FFu;                                                       \
        both -= both >> 5 & 0x00070007u;                                                           \
        both = (both + 0x00040004u) >> 3 & 0x001F001Fu;                                            \
        uint32_t green = pixel << 16 >> 24;                                                        \
        green = (green - (green >> 6) + 2) >> 2;                                                   \
        color[i] = both | both >> 5 | green << 5;                                                  \
    }
    QTRI_WORDS(count)
#undef ONE
}

void qtri_888_to_gray(uint32_t *color, int32_t count)
{
    uint32_t r = 19595; /* .299 .587 .114 of 2^16, whose sum they are */
    uint32_t g = 38470;
    uint32_t b = 7471;
    uint32_t half = 0x8000u;
#define ONE(i)                                                                                     \
    {                                                                                              \
        const uint32_t pixel = color[i];                                                           \
        color[i] =                                                                                 \
            ((pixel << 8 >> 24) * r + (pixel << 16 >> 24) * g + (pixel << 24 >> 24) * b + half) >> \
            16;                                                                                    \
        QTRI_ASIDE(half)                                                                           \
    }
    QTRI_WORDS(count)
#undef ONE
}
