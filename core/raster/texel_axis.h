/* SPDX-License-Identifier: MIT */
/*
 * Texture coordinates of a triangle. Internal.
 */
#ifndef QTRI_RASTER_TEXEL_AXIS_H
#define QTRI_RASTER_TEXEL_AXIS_H

#include "qtri/texture.h"

/*
 * One coordinate of a triangle, brought to 30 bits: whole repeats below the least of the three
 * are dropped, the rest is scaled, so that what is interpolated has no idle bits.
 *
 * A stage gets (value + bias) 2^up; a column or row is that >> texel_shift, wrapped.
 */
typedef struct qtri_texel_axis {
    uint8_t shift; /* of a value's fraction: 2..29 */
    int8_t up;     /* -12..20; 0 where coordinates do not fill 32 bits */
    uint8_t texel_shift;
    uint8_t side_log2;
    bool clamped;
    uint16_t mask; /* side - 1 */
    /* 2^-16 texel: values on a texel's edge, give or take an error, go up. To a filter coordinates
       count from texels' centres: less half a texel. */
    uint32_t bias;
    int32_t first; /* clamped: what is shifted, at coordinate 0: within +-2^29 */
} qtri_texel_axis;

/*
 * Coordinates as in qtri_screen_vertex; beyond 2^48 they are held there. value: at the vertices,
 * below 2^30. copy_shift: where a repeated coordinate's fraction ends, see texel_copy.h; 0: it does
 * not fill 32 bits.
 */
void qtri_texel_axis_init(qtri_texel_axis *axis, uint32_t value[3], const int64_t coordinate_q32[3],
                          uint8_t side_log2, bool clamped, int32_t copy_shift);

#endif
