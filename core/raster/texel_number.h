/* SPDX-License-Identifier: MIT */
/*
 * Where texture coordinates lead: to numbers of texels, row << width_log2 | column. Internal.
 *
 * Coordinates of a triangle are in one of two units. On an axis that repeats, of a texture of at
 * most 2^16 texels, all 32 bits count, so that they wrap by themselves and a number is quickly made
 * of them, see texel_copy.h. Elsewhere they are as texel_axis.h has them; those of clamped axes of
 * such textures are brought to 32 bits along a row, most by a look at both ends.
 */
#ifndef QTRI_RASTER_TEXEL_NUMBER_H
#define QTRI_RASTER_TEXEL_NUMBER_H

#include "batch.h"
#include "texel_axis.h"

/* `count` of 1..32, rounded up to a multiple of four, along a row. cut: see texel_copy.h. */
void qtri_texel_numbers_repeated(uint32_t *number, const qtri_curve uv[2], uint32_t cut,
                                 int32_t count);
/* The same, and in their place the texels of 16 bits that have them, in one. */
void qtri_texels_repeated_16(uint32_t *number, const qtri_curve uv[2], uint32_t cut,
                             const void *texels, int32_t count);

void qtri_texel_numbers(uint32_t *number, const qtri_curve uv[2], const qtri_texel_axis axis[2],
                        int32_t count);

/* The coordinates themselves. */
void qtri_texel_coordinates(uint32_t *u, uint32_t *v, const qtri_curve uv[2], int32_t count);

/*
 * Of `count` pixels of a clamped axis: brings the curve to 32 bits where all of them are inside the
 * texture, or all on one side of it. False, and nothing is changed, where it may be otherwise.
 * to: where the fraction ends then. Of a filtered texture, inside is between texels' centres.
 */
bool qtri_texel_curve_held(qtri_curve *curve, const qtri_texel_axis *axis, int32_t to,
                           int32_t count);

/* Any coordinates of a clamped axis, in place. */
void qtri_texel_coordinates_held(uint32_t *at, const qtri_texel_axis *axis, int32_t to,
                                 int32_t count);

/* The column or row of a coordinate's whole part. */
static inline uint32_t qtri_texel_wrapped(const qtri_texel_axis *axis, uint32_t whole)
{
    if (!axis->clamped) {
        return whole & axis->mask;
    }
    const int32_t index = (int32_t)whole - axis->first; /* whole <= 2^30, |first| < 2^29 */
    return index < 0 ? 0 : ((uint32_t)index > axis->mask ? axis->mask : (uint32_t)index);
}

#endif
