/* SPDX-License-Identifier: MIT */
#include "effect.h"

#include "job.h"

static uint32_t apply(const qtri_raster *raster, uint32_t *color, const qtri_fragments *at,
                      uint32_t mask, int32_t count)
{
    if (raster->fog != NULL) {
        raster->fog->stages->apply(raster, color, at, count);
    }
    return raster->blend != NULL ? raster->blend->apply(raster, color, at, mask, count) : mask;
}

const qtri_effect_stages qtri_effects = {apply, qtri_line_effects, qtri_span_fill,
                                         qtri_stroke_effects};
