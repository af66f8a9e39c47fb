/* SPDX-License-Identifier: MIT */
/*
 * Rows of RGB565 blended where they are, two pixels at a time. Internal.
 *
 * What blend.c makes of the same pixels is the same to the bit: rows save time and nothing else, a
 * fifth of what a smooth triangle takes, and fog's rows 5 to 6 %.
 */
#ifndef QTRI_RASTER_BLEND_ROW_H
#define QTRI_RASTER_BLEND_ROW_H

#include "../frame/barrier.h"
#include "effect.h"

/*
 * Pixels of RGB565, red and blue in one word: shares of 64 of 31 steps fit between them, and are
 * off by 1/128, .25 of a step; those of green are of 256, off by 1/512, .13 of one.
 */
typedef struct qtri_share_565 {
    uint32_t red_blue, green;
} qtri_share_565;

static inline qtri_share_565 qtri_share_565_of(uint32_t alpha)
{
    const qtri_share_565 share = {(alpha * 257 + 512) >> 10, alpha + (alpha >> 7)}; /* to nearest */
    return share;
}

/*
 * under + (color - under) share, rounded: with the half 64 under + difference share + 32 of each
 * channel is 32..2016, whatever lower ones borrow. What a loop needs before it; of a colour c over
 * a pixel u then x, red and blue, and c, green; and what the loop may keep in memory.
 */
#define QTRI_OVER_565_BEGIN(share)                                                                 \
    uint32_t mask = 0xF81Fu;                                                                       \
    uint32_t green_mask = 0x07E0u;                                                                 \
    uint32_t half = 0x10020u;                                                                      \
    uint32_t green_half = 0x1000u;                                                                 \
    uint32_t red_blue = (share).red_blue;                                                          \
    uint32_t green = (share).green;                                                                \
    QTRI_OPAQUE(mask)                                                                              \
    QTRI_OPAQUE(half)                                                                              \
    QTRI_OPAQUE(green_half)
#define QTRI_OVER_565(c, u)                                                                        \
    const uint32_t rb = (u)&mask;                                                                  \
    uint32_t x = (((c)&mask) - rb) * red_blue + half;                                              \
    (u) -= rb;                                                                                     \
    x = (rb + (uint32_t)((int32_t)x >> 6)) & mask;                                                 \
    (c) = (((c)&green_mask) - (u)) * green + green_half;                                           \
    (c) = ((u) + (uint32_t)((int32_t)(c) >> 8)) & green_mask;
#define QTRI_OVER_565_ASIDE                                                                        \
    QTRI_ASIDE(green_mask)                                                                         \
    QTRI_ASIDE(half)                                                                               \
    QTRI_ASIDE(green_half)                                                                         \
    QTRI_ASIDE(green)

/* See qtri_effect_row in raster.h. */
void qtri_blend_row_alpha(uint8_t *pixels, const uint32_t *color, int32_t count,
                          const qtri_raster *raster, uint32_t z, uint32_t z_step);
void qtri_blend_row_add(uint8_t *pixels, const uint32_t *color, int32_t count,
                        const qtri_raster *raster, uint32_t z, uint32_t z_step);

/*
 * The same of what waits in the batch, pixel by pixel in the order of drawing: some may lie on each
 * other.
 */
void qtri_blend_list_alpha(const qtri_raster *raster, int32_t count);
void qtri_blend_list_add(const qtri_raster *raster, int32_t count);

#endif
