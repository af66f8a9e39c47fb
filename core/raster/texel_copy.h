/* SPDX-License-Identifier: MIT */
/*
 * Texels that become pixels as they are: the nearest of a repeated RGB565 texture, unmodulated, on
 * an RGB565 surface. Internal.
 *
 * Coordinates of such runs are scaled so that an index is quickly made of them. A column is the top
 * of u, and wraps without a mask; a row is cut out of v so that it is shifted to its row of texels:
 *
 *     u: column (w bits), fraction (32 - w)        v: row (h bits), fraction (16 + w)
 *     index = (u >> (32 - w)) + ((v & row mask) >> 16)
 */
#ifndef QTRI_RASTER_TEXEL_COPY_H
#define QTRI_RASTER_TEXEL_COPY_H

#include "qtri/texture.h"

#include "../bits/bits.h"

/* x >> the low byte of `by`, 0..31. Arm's instruction looks at no other bits. */
static inline uint32_t qtri_shift_by_byte(uint32_t x, uint32_t by)
{
#if defined(__GNUC__) && defined(__thumb2__)
    __asm__("lsr %0, %1, %2" : "=r"(x) : "r"(x), "r"(by));
    return x;
#elif defined(__GNUC__) && defined(__thumb__)
    __asm__(".syntax unified\n\tlsrs %0, %1" : "+l"(x) : "l"(by) : "cc");
    return x;
#else
    return x >> (by & 31);
#endif
}

/* v fits: 1 <= w, w + h <= 16. */
static inline bool qtri_texel_copy_fits(const qtri_texture *texture)
{
    return texture->width_log2 >= 1 && texture->width_log2 <= 10 && texture->height_log2 <= 10 &&
           texture->width_log2 + texture->height_log2 <= 16;
}

/* Where u's and v's fractions end. */
static inline int32_t qtri_texel_copy_shift(const qtri_texture *texture, int axis)
{
    return axis == 0 ? 32 - texture->width_log2 : 16 + texture->width_log2;
}

/*
 * Row mask and column shift in one word, for one register: the mask leaves the low byte alone, and
 * what it lets through there is shifted away.
 */
static inline uint32_t qtri_texel_cut(const qtri_texture *texture)
{
    const uint32_t rows = ((uint32_t)1 << texture->height_log2) - 1;
    return rows << qtri_texel_copy_shift(texture, 1) | (uint32_t)qtri_texel_copy_shift(texture, 0);
}

static inline uint32_t qtri_texel_index(uint32_t u, uint32_t v, uint32_t cut)
{
    return qtri_shift_by_byte(u, cut) + ((v & cut) >> 16);
}

#endif
