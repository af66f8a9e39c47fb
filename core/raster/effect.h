/* SPDX-License-Identifier: MIT */
/*
 * What follows the colour of a fragment: fog, and a blend with the pixel under it. Internal.
 *
 * Both are reached through descriptions, so that an application without them has neither. They
 * work on fragments that lie on different pixels: of a row, or of one small triangle, where a batch
 * then ends with each.
 */
#ifndef QTRI_RASTER_EFFECT_H
#define QTRI_RASTER_EFFECT_H

#include "qtri/blend.h"

#include "raster.h"

struct qtri_effect_stages {
    /* Both, for `count` fragments in the mask; depth from place 0 on. Returns the new mask. */
    uint32_t (*apply)(const qtri_raster *raster, uint32_t *color, const uint32_t *place,
                      const qtri_ramp *depth, uint32_t mask, int32_t count);
    qtri_fill_rows fill; /* rows of large triangles, of one colour too */
};

/* Those that both descriptions name. */
extern const qtri_effect_stages qtri_effects[1];

struct qtri_fog_stages {
    const qtri_effect_stages *effects; /* qtri_effects */
    /* Colours, of the format's kind or `wide`, with 16-bit depths. */
    void (*apply)(const qtri_fog *fog, const qtri_format *format, uint32_t *color,
                  const uint16_t *depth, int32_t count, bool wide);
};
typedef struct qtri_fog_stages qtri_fog_stages;

struct qtri_blend {
    const qtri_effect_stages *effects; /* qtri_effects */
    /*
     * Colours, of the format's kind or `wide`, become what is stored there, of the format's kind,
     * in place. mask: as in batch.h; returns that of those that are drawn.
     */
    uint32_t (*apply)(const qtri_raster *raster, uint32_t *color, const uint32_t *place,
                      uint32_t mask, int32_t count);
    bool rejects; /* the mask may lose some */
};

#endif
