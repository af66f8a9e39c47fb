/* SPDX-License-Identifier: MIT */
/*
 * Colours in one word: 565 as RGB565 stores it, 888 as 0xAARRGGBB, gray as 0..255. Internal, part
 * of the pipelines' body (pipeline_make.h).
 *
 * Red and blue are two lanes of one product, 16 bits apart. A weight has 8 bits, 256 being 1.
 */
#ifndef QTRI_BODY_COLOR_H
#define QTRI_BODY_COLOR_H

#include <stdbool.h>
#include <stdint.h>

#include "../format.h"
#include "barrier.h"

/* The formats that pixels are computed in: see qtri_kind_of(). QTRI_IN_FINE_565: as 888, but red
   and blue have 8 for one of RGB565, and green 4. */
typedef enum qtri_color_kind {
    QTRI_IN_565,
    QTRI_IN_888,
    QTRI_IN_GRAY,
    QTRI_IN_FINE_565
} qtri_color_kind;

#define QTRI_BODY_LANES_565 0x001F001Fu
#define QTRI_BODY_LANES_888 0x00FF00FFu

/* Red and blue of RGB565: red << 16 | blue; and a colour of such lanes, which have no other bits,
   and its green. */
QTRI_BODY uint32_t qtri_pixel_lanes_565(uint32_t c)
{
    return (c | c << 5) & QTRI_BODY_LANES_565;
}

QTRI_BODY uint32_t qtri_green_565(uint32_t c)
{
    return c >> 5 & 63;
}

/* Red is left above bit 15 too: stores cut it, lanes are the same with it. */
QTRI_BODY uint32_t qtri_join_565(uint32_t lanes, uint32_t green)
{
    return lanes | lanes >> 5 | green << 5;
}

QTRI_BODY uint32_t qtri_green_888(uint32_t c)
{
    return c >> 8 & 255;
}

/* These of either kind, 565 or 888. */
QTRI_BODY uint32_t qtri_lanes_mask(qtri_color_kind kind)
{
    return kind == QTRI_IN_565 ? QTRI_BODY_LANES_565 : QTRI_BODY_LANES_888;
}

QTRI_BODY uint32_t qtri_lanes_of(qtri_color_kind kind, uint32_t c)
{
    return kind == QTRI_IN_565 ? qtri_pixel_lanes_565(c) : c & QTRI_BODY_LANES_888;
}

QTRI_BODY uint32_t qtri_green_of(qtri_color_kind kind, uint32_t c)
{
    return kind == QTRI_IN_565 ? qtri_green_565(c) : qtri_green_888(c);
}

QTRI_BODY uint32_t qtri_join(qtri_color_kind kind, uint32_t lanes, uint32_t green)
{
    return kind == QTRI_IN_565 ? qtri_join_565(lanes, green)
           /* GCC sees that these are apart, and does not split them again */
           : kind == QTRI_IN_FINE_565 ? lanes | (green & 255) << 8
                                      : lanes | green << 8;
}

/* c a + o (256 - a), to nearest; a <= 256. A sum of products: c a is found once where both are
   constant. Alpha of 888 becomes 0. */
QTRI_BODY uint32_t qtri_color_mix(qtri_color_kind kind, uint32_t c, uint32_t a, uint32_t o)
{
    const uint32_t b = 256 - a;
    if (kind == QTRI_IN_GRAY) {
        return (c * a + o * b + 128) >> 8;
    }
    const uint32_t lanes = qtri_lanes_of(kind, c) * a + qtri_lanes_of(kind, o) * b + 0x00800080u;
    const uint32_t green = qtri_green_of(kind, c) * a + qtri_green_of(kind, o) * b + 128;
    return qtri_join(kind, lanes >> 8 & qtri_lanes_mask(kind), green >> 8);
}

/* The result of qtri_color_mix(), by the difference to o: less where o is constant, or nothing. */
QTRI_BODY uint32_t qtri_color_fade(qtri_color_kind kind, uint32_t c, uint32_t a, uint32_t o)
{
    if (kind == QTRI_IN_GRAY) {
        return (o * 256 + 128 + (c - o) * a) >> 8;
    }
    const uint32_t lanes = qtri_lanes_of(kind, o), green = qtri_green_of(kind, o);
    const uint32_t l = lanes * 256 + 0x00800080u + (qtri_lanes_of(kind, c) - lanes) * a;
    const uint32_t g = green * 256 + 128 + (qtri_green_of(kind, c) - green) * a;
    return qtri_join(kind, l >> 8 & qtri_lanes_mask(kind), g >> 8);
}

/* qtri_color_fade() of fine colours to RGB565, rounded once: 248 256 + 1024 < 2^16. */
QTRI_BODY uint32_t qtri_color_fade_fine(uint32_t c, uint32_t a, uint32_t o)
{
    const uint32_t lanes = o & QTRI_BODY_LANES_888, green = qtri_green_888(o);
    const uint32_t l = lanes * 256 + 0x04000400u + ((c & QTRI_BODY_LANES_888) - lanes) * a;
    const uint32_t g = green * 256 + 512 + (qtri_green_888(c) - green) * a;
    return qtri_join_565(l >> 11 & QTRI_BODY_LANES_565, g >> 10);
}

QTRI_BODY uint32_t qtri_color_scale(qtri_color_kind kind, uint32_t c, uint32_t a)
{
    return qtri_color_fade(kind, c, a, 0);
}

/* sum + a b, both factors below 2^15. By half-words, lit textures cost a Cortex-M4 5 % less. */
QTRI_BODY uint32_t qtri_add_product16(uint32_t sum, uint32_t a, uint32_t b)
{
#if defined(__ARM_FEATURE_DSP) && !defined(__OPTIMIZE_SIZE__)
    QTRI_BODY_BARRIER(a); /* or GCC 12 sees its sign, and no half-word */
    return sum + (uint32_t)((int32_t)(int16_t)a * (int16_t)b);
#else
    return sum + a * b;
#endif
}

/* Channels of a texel, 565 or 888, times a weight each: 64 is 1 in 565, 256 in 888. */
QTRI_BODY uint32_t qtri_color_modulate(qtri_color_kind kind, uint32_t c, uint32_t r, uint32_t g,
                                       uint32_t b)
{
    if (kind == QTRI_IN_565) {
        return ((c >> 11) * r + 32) >> 6 << 11 | (qtri_green_565(c) * g + 32) >> 6 << 5 |
               ((c & 31) * b + 32) >> 6;
    }
    return ((c >> 16 & 255) * r + 128) >> 8 << 16 | ((qtri_green_888(c) * g + 128) & 0xFF00u) |
           ((c & 255) * b + 128) >> 8;
}

/* All channels times one weight: the result of qtri_color_modulate() with r = g = b. */
QTRI_BODY uint32_t qtri_color_modulate_intensity(qtri_color_kind kind, uint32_t c, uint32_t weight)
{
    if (kind == QTRI_IN_565) { /* red and blue, 11 bits apart, have 6 more each: 31 64 < 2^11 */
        uint32_t mask = 0xF81Fu;
        QTRI_BODY_BARRIER(mask); /* or GCC 12 has a constant of its own for each use */
        uint32_t lanes = c & mask;
        uint32_t green = (c ^ lanes) * weight + (32u << 5);
        lanes = lanes * weight + (32u << 11 | 32);
        return (lanes >> 6 & mask) | (green >> 6 & ~mask);
    }
    return qtri_color_scale(kind, c, weight);
}

/* The product of two colours by channel, full intensity being 1. */
QTRI_BODY uint32_t qtri_color_product(qtri_color_kind kind, uint32_t c, uint32_t o)
{
    if (kind == QTRI_IN_GRAY) {
        const uint32_t p = c * o + 128;
        return (p + (p >> 8)) >> 8;
    }
    if (kind == QTRI_IN_565) { /* p / 31 = p 1057 / 2^15, p / 63 = p 1040 / 2^16, within .02 */
        return ((c >> 11 & 31) * (o >> 11) * 1057u + 16384) >> 15 << 11 |
               (qtri_green_565(c) * qtri_green_565(o) * 1040u + 32768) >> 16 << 5 |
               ((c & 31) * (o & 31) * 1057u + 16384) >> 15;
    }
    const uint32_t r = (c >> 16 & 255) * (o >> 16 & 255) + 128;
    const uint32_t g = qtri_green_888(c) * qtri_green_888(o) + 128;
    const uint32_t b = (c & 255) * (o & 255) + 128;
    return (r + (r >> 8)) >> 8 << 16 | ((g + (g >> 8)) & 0xFF00u) | (b + (b >> 8)) >> 8;
}

/* o + c a by channel, saturated: a channel that overflows becomes all ones. */
QTRI_BODY uint32_t qtri_color_add(qtri_color_kind kind, uint32_t o, uint32_t c, uint32_t a)
{
    if (kind == QTRI_IN_GRAY) {
        const uint32_t sum = o + qtri_color_scale(kind, c, a);
        return sum > 255 ? 255 : sum;
    }
    const uint32_t mask = qtri_lanes_mask(kind), bits = kind == QTRI_IN_565 ? 5 : 8;
    const uint32_t most = kind == QTRI_IN_565 ? 63 : 255;
    uint32_t lanes = (qtri_lanes_of(kind, c) * a + 0x00800080u) >> 8 & mask;
    lanes += qtri_lanes_of(kind, o);
    const uint32_t over = lanes & (mask + 0x00010001u); /* the bits above channels */
    lanes = (lanes | (over - (over >> bits))) & mask;
    const uint32_t green = ((qtri_green_of(kind, c) * a + 128) >> 8) + qtri_green_of(kind, o);
    return qtri_join(kind, lanes, green > most ? most : green);
}

/* Conversions, loads and stores ---------------------------------------------------------------- */

QTRI_BODY uint32_t qtri_pixel_rgb_to_888(const qtri_rgb *color)
{
    // NOLINTNEXTLINE(clang-analyzer-core.NullDereference): of a palette that the walk has
    return (uint32_t)color->r << 16 | (uint32_t)color->g << 8 | color->b;
}

/* Texels with alpha to 0xAARRGGBB: four bits are repeated; 31 becomes 255, to nearest between. */
QTRI_BODY uint32_t qtri_pixel_4444_to_8888(uint32_t c)
{
    c = (c & 0xF000u) << 12 | (c & 0x0F00u) << 8 | (c & 0x00F0u) << 4 | (c & 15u);
    return c | c << 4;
}

QTRI_BODY uint32_t qtri_pixel_1555_to_8888(uint32_t c)
{
    const uint32_t lanes = ((c << 6 & 0x001F0000u) | (c & 31)) * 527u + 0x00170017u;
    return ((c & 0x8000u) != 0 ? 0xFF000000u : 0) | (lanes >> 6 & QTRI_BODY_LANES_888) |
           ((c >> 5 & 31) * 527u + 23) >> 6 << 8;
}

/* To nearest: 255 / 31 and 255 / 63 of a channel. */
QTRI_BODY uint32_t qtri_pixel_565_to_888(uint32_t c)
{
    const uint32_t lanes = qtri_pixel_lanes_565(c) * 527u + 0x00170017u; /* 14 bits each */
    return (lanes >> 6 & QTRI_BODY_LANES_888) | (qtri_green_565(c) * 259u + 33) >> 6 << 8;
}

/* To nearest: c 31 / 255 = (c 249 + 1014) / 2^11 and c 63 / 255 = (c 253 + 505) / 2^10. */
QTRI_BODY uint32_t qtri_pixel_888_to_565(uint32_t c)
{
    uint32_t factor = 249;
    QTRI_BODY_BARRIER(factor); /* or GCC 12 shifts and adds in place of products */
    const uint32_t lanes = (c & QTRI_BODY_LANES_888) * factor + 1014u * 0x10001u; /* 16 bits each */
    factor += 253 - 249;
    QTRI_BODY_BARRIER(factor);
    return lanes >> 27 << 11 | (qtri_body_bits(c, 8, 8) * factor + 505) >> 10 << 5 |
           qtri_body_bits(lanes, 11, 5);
}

/* Fine colours: of RGB565 exactly. */
QTRI_BODY uint32_t qtri_pixel_565_to_fine(uint32_t c)
{
    return qtri_pixel_lanes_565(c) << 3 | (c << 5 & 0xFC00u);
}

/* c 248 / 255 as c - c / 32, off by 7/8 of 1/8 of a step; green c 252 / 255 to nearest: less (3 c +
   127) / 256. What is above the channels stays. */
QTRI_BODY uint32_t qtri_pixel_888_to_fine(uint32_t c)
{
    return c - (c >> 5 & 0x00070007u) - ((qtri_green_888(c) * 3 + 127) & 0x300u);
}

/* .299 R + .587 G + .114 B, to nearest. */
QTRI_BODY uint32_t qtri_pixel_888_to_luma(uint32_t c)
{
    return ((c >> 16 & 255) * 19595u + qtri_green_888(c) * 38470u + (c & 255) * 7471u + 32768u) >>
           16;
}

/* Luma of 565: c 255 / 31 .114 = c 120 / 2^7, c 255 / 63 .587 = c 304 / 2^7, c 255 / 31 .299 =
   c 315 / 2^7, within .07 in all. */
QTRI_BODY uint32_t qtri_pixel_565_to_luma(uint32_t c)
{
    uint32_t factor = 120;
    QTRI_BODY_BARRIER(factor); /* as above */
    uint32_t sum = qtri_body_bits(c, 0, 5) * factor + 64;
    QTRI_BODY_BARRIER(sum); /* or all three need registers at once */
    factor += 304 - 120;
    QTRI_BODY_BARRIER(factor);
    sum += qtri_body_bits(c, 5, 6) * factor;
    QTRI_BODY_BARRIER(sum);
    factor += 315 - 304;
    QTRI_BODY_BARRIER(factor);
    return (sum + (c >> 11) * factor) >> 7;
}

/* A pixel or depth of 1 to 4 bytes; 0 bytes: 0, and no store.
 * NOLINTBEGIN(clang-analyzer-core.NullDereference) */
QTRI_BODY uint32_t qtri_load(uint32_t bytes, const uint8_t *at)
{
    switch (bytes) {
    case 2:
        return *(const uint16_t *)(const void *)at;
    case 4:
        return *(const uint32_t *)(const void *)at;
    case 3:
        return (uint32_t)at[0] | (uint32_t)at[1] << 8 | (uint32_t)at[2] << 16;
    case 1:
        return *at;
    default:
        return 0;
    }
}

QTRI_BODY void qtri_save(uint32_t bytes, uint8_t *at, uint32_t word)
{
    switch (bytes) {
    case 2:
        *(uint16_t *)(void *)at = (uint16_t)word;
        break;
    case 4:
        *(uint32_t *)(void *)at = word;
        break;
    case 3:
        at[1] = (uint8_t)(word >> 8);
        at[2] = (uint8_t)(word >> 16);
        at[0] = (uint8_t)word;
        break;
    case 1:
        *at = (uint8_t)word;
        break;
    default:
        break;
    }
}
/* NOLINTEND(clang-analyzer-core.NullDereference) */

/* The two low bytes exchanged; GCC 12 does not see the instruction for it in every pixel. */
QTRI_BODY uint32_t qtri_swap_16(uint32_t c)
{
#ifdef __GNUC__
    return __builtin_bswap16((uint16_t)c);
#else
    return (c >> 8 & 0xFFu) | (c & 0xFFu) << 8;
#endif
}

/* 0x00BBGGRR of 0xXXRRGGBB, and back. */
QTRI_BODY uint32_t qtri_swap_red_blue(uint32_t c)
{
#ifdef __GNUC__
    return __builtin_bswap32(c) >> 8;
#else
    return (c >> 16 & 0xFFu) | (c & 0xFF00u) | (c & 0xFFu) << 16;
#endif
}

#endif
