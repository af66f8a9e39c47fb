/* SPDX-License-Identifier: MIT */
/*
 * Rows of RGB565 blended where they are, two pixels at a time. Internal.
 *
 * What blend.c makes of the same pixels is the same to the bit: rows save time and nothing else, a
 * fifth of what a smooth triangle takes, and fog's rows 5 to 6 %.
 */
#ifndef QTRI_RASTER_BLEND_ROW_H
#define QTRI_RASTER_BLEND_ROW_H

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
