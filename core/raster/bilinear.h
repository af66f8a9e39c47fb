/* SPDX-License-Identifier: MIT */
/*
 * What a filter is. Internal.
 */
#ifndef QTRI_RASTER_BILINEAR_H
#define QTRI_RASTER_BILINEAR_H

#include "raster.h"

struct qtri_filter {
    /* What else a raster needs that has its texture and kinds of colours; it may put another
       texture in place of it, with another filter or none. */
    void (*init)(qtri_raster *raster);
    /*
     * Colours of the kind that the raster works in from coordinates, u in place; v is lost. They
     * fill 32 bits where there is no axis. Returns the mask of those that are drawn: all without a
     * key.
     */
    uint32_t (*sample)(const qtri_raster *raster, const qtri_texel_axis axis[2], uint32_t *u,
                       uint32_t *v, int32_t count);
    bool is_bilinear, is_mipmapped;
};

/* Of qtri_bilinear. */
void qtri_bilinear_init(qtri_raster *raster);

#endif
