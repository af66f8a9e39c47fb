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

#include "job.h"

/* Nearest, repeated, without a key, and v fits: 1 <= w, w + h <= 16. */
static inline bool qtri_texel_copy_fits(const qtri_texture *texture)
{
    return texture->format == QTRI_TEXEL_RGB565 && texture->filter != QTRI_BILINEAR &&
           texture->wrap_u != QTRI_CLAMP && texture->wrap_v != QTRI_CLAMP && !texture->has_key &&
           texture->width_log2 >= 1 && texture->width_log2 <= 10 && texture->height_log2 <= 10 &&
           texture->width_log2 + texture->height_log2 <= 16;
}

/* Where u's and v's fractions end. */
static inline int32_t qtri_texel_copy_shift(const qtri_texture *texture, int axis)
{
    return axis == 0 ? 32 - texture->width_log2 : 16 + texture->width_log2;
}

static inline uint32_t qtri_texel_copy_rows(const qtri_texture *texture)
{
    return (((uint32_t)1 << texture->height_log2) - 1) << (16 + texture->width_log2);
}

static inline uint32_t qtri_texel_copied(const qtri_raster *raster, uint32_t u, uint32_t v)
{
    uint32_t index = (u >> raster->column_shift) + ((v & raster->row_mask) >> 16);
    return ((const uint16_t *)raster->texture->texels)[index];
}

#endif
