/* SPDX-License-Identifier: MIT */
#include "colors.h"

#include "curves.h"

/* white / (255 << 16) in Q30, rounded: times a colour of 24 bits, off by less than 2^-6 units. */
#define RATIO_Q30(white)                                                                           \
    ((uint32_t)((((uint64_t)(white) << 30) + ((uint32_t)255 << 15)) / ((uint32_t)255 << 16)))

#define WHITE(red, green, blue)                                                                    \
    {(red), (green), (blue)},                                                                      \
    {                                                                                              \
        RATIO_Q30(red), RATIO_Q30(green), RATIO_Q30(blue)                                          \
    }

static uint32_t pack_565(const int32_t channel[3])
{
    return qtri_pack_565(channel);
}

static uint32_t pack_888(const int32_t channel[3])
{
    return qtri_pack_888(channel);
}

static uint32_t pack_gray(const int32_t channel[3])
{
    return qtri_pack_gray(channel);
}

static inline uint32_t magnitude(uint32_t x)
{
    return (int32_t)x < 0 ? 0 - x : x;
}

/* n.16 in one word with fractions of five bits, see raster/packed.h. */
static inline uint32_t packed_565(uint32_t r, uint32_t g, uint32_t b)
{
    return (r >> 10 << 21) + (b & ~(uint32_t)0x7FF) + (uint32_t)((int32_t)g >> 11);
}

static inline uint32_t eighth(uint32_t rise, uint32_t half)
{
    return (uint32_t)((int32_t)rise >> 3) + half;
}

#define QTRI_PACKED_565(i)                                                                         \
    {                                                                                              \
        const uint32_t shown = packed & mask;                                                      \
        color[i] = shown | shown >> 16;                                                            \
        packed += step;                                                                            \
        QTRI_OPAQUE(packed)                                                                        \
    }

/* Along chords of eight pixels: a curve leaves them by bend 8^2 / 8. */
static void chords_565(uint32_t *color, const qtri_curve *c, int32_t count)
{
    uint32_t mask = 0xF81F07E0u;
    uint32_t at[3] = {c[0].at, c[1].at, c[2].at};
    uint32_t rise[3];
    for (int i = 0; i < 3; i++) {
        rise[i] = 8 * c[i].step + 28 * c[i].bend;
    }
    QTRI_OPAQUE(mask)
    for (;;) {
        uint32_t packed = packed_565(at[0], at[1], at[2]);
        const uint32_t step =
            packed_565(eighth(rise[0], 0x200), eighth(rise[1], 0x400), eighth(rise[2], 0x400));
        int32_t some = count < 8 ? count : 8;
        QTRI_CURVE_WORDS(color, some, QTRI_PACKED_565)
        count -= 8;
        if (count <= 0) {
            return;
        }
        for (int i = 0; i < 3; i++) {
            at[i] += rise[i];
            rise[i] += 64 * c[i].bend;
        }
    }
}

#define QTRI_STRAIGHT_565(i)                                                                       \
    color[i] = r >> 16 << 11 | g >> 16 << 5 | b >> 16;                                             \
    QTRI_STEP_THREE

#define QTRI_CURVED_565(i) QTRI_STRAIGHT_565(i) QTRI_BEND_THREE

/* Chords where they are within 1/8 of a step. */
static void smooth_565(uint32_t *color, const qtri_curve *c, int32_t count)
{
    const uint32_t most = magnitude(c[0].bend) | magnitude(c[1].bend) | magnitude(c[2].bend);
    if (most < 1024) {
        chords_565(color, c, count);
    } else {
        QTRI_CURVED_CURVES(color, c, 0, count, 565)
    }
}

#define QTRI_STRAIGHT_888(i)                                                                       \
    color[i] = r >> 16 << 16 | g >> 16 << 8 | b >> 16;                                             \
    QTRI_STEP_THREE

#define QTRI_CURVED_888(i) QTRI_STRAIGHT_888(i) QTRI_BEND_THREE

static void smooth_888(uint32_t *color, const qtri_curve *c, int32_t count)
{
    QTRI_THREE_CURVES(color, c, 0, count, 888)
}

static void smooth_gray(uint32_t *color, const qtri_curve *c, int32_t count)
{
    uint32_t luma = c->at;
    uint32_t step = c->step;
    for (; count > 0; count--) {
        *color++ = luma >> 16;
        luma += step;
        step += c->bend;
    }
}

const qtri_colors qtri_colors_565 = {WHITE((int32_t)31 << 16, (int32_t)63 << 16, (int32_t)31 << 16),
                                     false,
                                     11,
                                     5,
                                     7,
                                     0,
                                     pack_565,
                                     smooth_565};

const qtri_colors qtri_colors_888 = {
    WHITE((int32_t)255 << 16, (int32_t)255 << 16, (int32_t)255 << 16),
    false,
    16,
    8,
    10,
    0,
    pack_888,
    smooth_888};

const qtri_colors qtri_colors_gray = {WHITE(QTRI_GRAY_RED, QTRI_GRAY_GREEN, QTRI_GRAY_BLUE),
                                      true,
                                      0,
                                      0,
                                      10,
                                      0,
                                      pack_gray,
                                      smooth_gray};
