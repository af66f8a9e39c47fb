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

static uint32_t magnitude(uint32_t x)
{
    return (int32_t)x < 0 ? 0 - x : x;
}

/*
 * In pieces of 2^log2 pixels along chords, in one word with fractions of five bits, see
 * raster/packed.h: a curve leaves its chord by bend 4^log2 / 8, which is held below 1/8 of a step.
 */
static void smooth_565(uint32_t *color, const qtri_curve *c, int32_t count)
{
    const uint32_t mask = 0xF81F07E0u;
    const uint32_t most = magnitude(c[0].bend) | magnitude(c[1].bend) | magnitude(c[2].bend);
    uint32_t at[3] = {c[0].at, c[1].at, c[2].at};
    uint32_t step[3] = {c[0].step, c[1].step, c[2].step};
    int32_t log2 = 3;
    for (uint32_t limit = 1024; log2 > 0 && most >= limit; limit <<= 2) {
        log2--;
    }
    const int32_t size = (int32_t)1 << log2;
    do {
        uint32_t rise[3];
        for (int i = 0; i < 3; i++) {
            rise[i] = (step[i] << log2) + (uint32_t)(size * (size - 1) / 2) * c[i].bend;
        }
        uint32_t packed =
            (at[0] >> 10 << 21) + (at[2] & ~(uint32_t)0x7FF) + (uint32_t)((int32_t)at[1] >> 11);
        const uint32_t red = (uint32_t)((int32_t)rise[0] >> log2) + 0x200;
        const uint32_t green = (uint32_t)((int32_t)rise[1] >> log2) + 0x400;
        const uint32_t blue = (uint32_t)((int32_t)rise[2] >> log2) + 0x400;
        const uint32_t packed_step =
            (red >> 10 << 21) + (blue & ~(uint32_t)0x7FF) + (uint32_t)((int32_t)green >> 11);
        for (int32_t i = 0; i < size; i++) {
            const uint32_t shown = packed & mask;
            *color++ = shown | shown >> 16;
            packed += packed_step;
        }
        for (int i = 0; i < 3; i++) {
            at[i] += rise[i];
            step[i] += c[i].bend << log2;
        }
    } while ((count -= size) > 0);
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
                                     pack_565,
                                     smooth_565};

const qtri_colors qtri_colors_888 = {
    WHITE((int32_t)255 << 16, (int32_t)255 << 16, (int32_t)255 << 16),
    false,
    16,
    8,
    10,
    pack_888,
    smooth_888};

const qtri_colors qtri_colors_gray = {
    WHITE(QTRI_GRAY_RED, QTRI_GRAY_GREEN, QTRI_GRAY_BLUE), true, 0, 0, 10, pack_gray, smooth_gray};
