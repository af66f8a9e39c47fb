/*
 * Texture coordinates and texel fetch. Internal.
 */
#ifndef QTRI_RASTER_TEXEL_H
#define QTRI_RASTER_TEXEL_H

#include "qtri/material.h"

#include "../frame/pixel.h"

/*
 * One coordinate of a triangle, brought to 30 bits: whole repeats below the least of the three
 * are dropped, the rest is scaled, so that what is interpolated has no idle bits.
 */
typedef struct qtri_texel_axis {
    uint8_t shift; /* texel = (value + bias) >> shift, wrapped: 2..29 */
    int8_t up;     /* runs have (value + bias) 2^up: -12..20 */
    uint16_t mask; /* side - 1 */
    uint32_t bias; /* 2^-16 texel: values on a texel's edge, give or take an error, go up */
    int32_t first; /* (value + 2^30) >> shift at coordinate 0: within +-2^29 */
} qtri_texel_axis;

/*
 * All but `up`. Coordinates as in qtri_screen_vertex; beyond 2^48 they are held there. value: at
 * the vertices, below 2^30.
 */
void qtri_texel_axis_init(qtri_texel_axis *axis, uint32_t value[3], const int64_t coordinate_q32[3],
                          uint8_t side_log2);

/* Whether a material's texture can be read at all. */
bool qtri_texture_usable(const qtri_texture *texture);

/*
 * color times what the texture has at u, v, which have the bias added: wrapped and filtered as it
 * says. False, and color as it was, where that is the colour key.
 */
bool qtri_texel_apply(const qtri_texture *texture, const qtri_texel_axis axis[2], uint32_t u,
                      uint32_t v, qtri_channels *color);

#endif
