/* SPDX-License-Identifier: MIT */
/*
 * Shares of a raster's tint: the one colour that light is multiplied by. Internal.
 */
#ifndef QTRI_RASTER_TINT_H
#define QTRI_RASTER_TINT_H

#include "raster.h"

/* The widest of the tint's channels, with 8 bits after the point: below 2^16. */
static inline uint32_t qtri_raster_widest_tint(const qtri_raster *raster)
{
    const uint32_t *tint = raster->tint_n8;
    const uint32_t widest = tint[0] > tint[1] ? tint[0] : tint[1];
    return widest > tint[2] ? widest : tint[2];
}

/* share_q22 <= 2^22 of a tint's channel, or of a step of it. */
static inline int32_t qtri_raster_shade(const qtri_raster *raster, int32_t share_q22, int i)
{
    return (int32_t)(qtri_mul_s32(share_q22, raster->tint.c[i]) >> 22);
}

/*
 * The tint at a light of `bits` bits and 1, at most 2^15, as a colour: channels, 2^16 at most, are
 * rounded once, so within 1/2 + 2^-8 of a step and what the light is off by.
 */
static inline uint32_t qtri_raster_tinted(const qtri_raster *raster, uint32_t light, uint32_t bits)
{
    const qtri_colors *colors = raster->units;
    const uint32_t shift = 8 + bits;
    const uint32_t half = (uint32_t)1 << (shift - 1);
    uint32_t color = (light * raster->tint_n8[2] + half) >> shift;
    if (!colors->single) {
        color |= (light * raster->tint_n8[0] + half) >> shift << colors->red;
        color |= (light * raster->tint_n8[1] + half) >> shift << colors->green;
    }
    return color;
}

#endif
