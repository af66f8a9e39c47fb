/* SPDX-License-Identifier: MIT */
/*
 * Alpha blending of stored pixels: d (256 - a) + s a, a being 0..256, each channel rounded once.
 * Internal.
 *
 * A weight of 255 steps in 256 is off by 1/512: with the rounding, 1 of 255 and .63 of a step of
 * RGB565.
 *
 * Channels that are whole bytes may stand in any order, and those of RGB565 may have their bytes
 * exchanged: such pixels are mixed as they are stored, two channels at a time. Of other formats
 * only what `decode` and `encode` say is known.
 */
#ifndef QTRI_PAINT_MIX_STORED_H
#define QTRI_PAINT_MIX_STORED_H

#include "../bits/bits.h"
#include "../frame/pixel.h"

/* Formats whose stored pixels are blended directly, and all others. */
typedef enum qtri_mix {
    QTRI_MIX_GRAY8,
    QTRI_MIX_565,
    QTRI_MIX_565_SWAPPED,
    QTRI_MIX_24,
    QTRI_MIX_32,
    QTRI_MIX_OTHER
} qtri_mix;

enum { QTRI_MIX_BATCH = 16 }; /* colours that are gathered at a time */

qtri_mix qtri_mix_of(const qtri_format *format);

/* coverage alpha / 255^2 of 256, rounded: 258 / 2^16 is 256 / 255^2 within 2^-18. */
static inline uint32_t qtri_mix_weight(uint32_t coverage, uint32_t alpha)
{
    return (coverage * alpha * 258u + 0x8000u) >> 16;
}

static inline uint32_t qtri_mix_red_blue(uint32_t x)
{
    return (x & 0x1F) | (x & 0xF800) << 5;
}

/*
 * Blends `count` pixels, 1..32, of a format that is QTRI_MIX_OTHER: those with a bit in the mask,
 * the lowest for the last, with colours a - 1 << 24 | 0xRRGGBB, a of 256. `color` has room for a
 * multiple of four.
 */
void qtri_mix_others(const qtri_format *format, uint8_t *at, uint32_t *color, uint32_t mask,
                     int32_t count);

/* Turns 0x00RRGGBB, in place, into stored pixels; `color` has room for a multiple of four. */
static inline void qtri_mix_encode(const qtri_format *format, uint32_t *color, int32_t count)
{
    const uint32_t *end = color + count;
    if (format->colors == &qtri_colors_565) {
        for (uint32_t *c = color; c != end; c++) {
            *c = qtri_pixel_888_to_565(*c);
        }
    } else if (format->colors == &qtri_colors_gray) {
        for (uint32_t *c = color; c != end; c++) {
            *c = qtri_pixel_888_to_luma(*c);
        }
    }
    if (format->encode != NULL) {
        format->encode(color, count);
    }
}

/*
 * A colour times its weight with the half that rounds, as lanes of 16 bits, 255 * 256 + 128 < 2^16:
 * what is added to every pixel.
 */
typedef struct qtri_mix_part {
    uint32_t low, high; /* bits 0 and 16 on; of RGB565 low is blue and red, high green */
} qtri_mix_part;

/* A channel, n.16 up to 255.0, times a, less than 2^24 in 1/256, plus the half that rounds. */
static inline uint32_t qtri_mix_channel(int32_t channel, uint32_t a)
{
    return ((uint32_t)channel >> 8) * a / 256 + 128;
}

/* The part of a stored pixel, times a of 256. */
QTRI_INLINE qtri_mix_part qtri_mix_part_of_stored(qtri_mix mix, uint32_t stored, uint32_t a)
{
    const uint32_t mask = 0x00FF00FFu;
    qtri_mix_part share;
    if (mix == QTRI_MIX_GRAY8) {
        share.low = (stored & 0xFF) * a + 128;
        share.high = 0;
    } else if (mix == QTRI_MIX_24 || mix == QTRI_MIX_32) {
        share.low = (stored & mask) * a + 0x00800080u;
        share.high = (stored >> 8 & mask) * a + 0x00800080u;
    } else {
        stored = mix == QTRI_MIX_565_SWAPPED ? qtri_swap_16(stored) : stored;
        share.low = qtri_mix_red_blue(stored) * a + 0x00800080u;
        share.high = (stored >> 5 & 63) * a + 128;
    }
    return share;
}

/* The part of a colour: of exact channels where steps are coarse, else of the stored pixel. */
QTRI_INLINE qtri_mix_part qtri_mix_part_of(qtri_mix mix, const qtri_channels *channels,
                                           uint32_t stored, uint32_t a)
{
    const int32_t *c = channels->c;
    qtri_mix_part share;
    if (mix == QTRI_MIX_24 || mix == QTRI_MIX_32) {
        return qtri_mix_part_of_stored(mix, stored, a);
    }
    if (mix == QTRI_MIX_GRAY8) {
        share.low = qtri_mix_channel(c[0] + c[1] + c[2], a);
        share.high = 0;
    } else {
        share.low = qtri_mix_channel(c[2], a) | qtri_mix_channel(c[0], a) << 16;
        share.high = qtri_mix_channel(c[1], a);
    }
    return share;
}

/* The stored pixel d (256 - a) + s a; keep = 256 - a. */
QTRI_INLINE uint32_t qtri_mix_add(qtri_mix mix, uint32_t d, uint32_t keep, qtri_mix_part share)
{
    const uint32_t mask = 0x00FF00FFu;
    if (mix == QTRI_MIX_GRAY8) {
        return (d * keep + share.low) >> 8;
    }
    if (mix == QTRI_MIX_24 || mix == QTRI_MIX_32) {
        const uint32_t low = (d & mask) * keep + share.low;
        const uint32_t high = (d >> 8 & mask) * keep + share.high;
        return (low >> 8 & mask) | (high & ~mask);
    }
    d = mix == QTRI_MIX_565_SWAPPED ? qtri_swap_16(d) : d;
    const uint32_t rb = (qtri_mix_red_blue(d) * keep + share.low) >> 8;
    const uint32_t g = ((d >> 5 & 63) * keep + share.high) >> 8;
    d = (rb & 0x1F) | g << 5 | (rb >> 5 & 0xF800);
    return mix == QTRI_MIX_565_SWAPPED ? qtri_swap_16(d) : d;
}

/* The cases of a switch over qtri_mix_of(): calls `function` with the kind and its bytes, constants
   that the compiler makes a loop each of. */
#define QTRI_MIX_CASES(function, ...)                                                              \
    case QTRI_MIX_GRAY8:                                                                           \
        function(QTRI_MIX_GRAY8, 1, __VA_ARGS__);                                                  \
        break;                                                                                     \
    case QTRI_MIX_565:                                                                             \
        function(QTRI_MIX_565, 2, __VA_ARGS__);                                                    \
        break;                                                                                     \
    case QTRI_MIX_565_SWAPPED:                                                                     \
        function(QTRI_MIX_565_SWAPPED, 2, __VA_ARGS__);                                            \
        break;                                                                                     \
    case QTRI_MIX_24:                                                                              \
        function(QTRI_MIX_24, 3, __VA_ARGS__);                                                     \
        break;                                                                                     \
    case QTRI_MIX_32:                                                                              \
        function(QTRI_MIX_32, 4, __VA_ARGS__);                                                     \
        break

#endif
