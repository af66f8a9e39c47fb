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

/* Plain pixels are colours of the kind 565 as they are, of which all channels are written. */
static void choose(qtri_raster *raster)
{
    const qtri_format *format = raster->format;
    if (format->colors != &qtri_colors_565 || format->encode != NULL ||
        format->pixels->bytes != 2 || raster->wide || raster->keep != 0) {
        return;
    }
    if (qtri_list_tint_fits(raster)) {
        raster->tint_small = qtri_list_tint;
    }
    if (raster->fog == NULL) {
        raster->effect_row = raster->blend->row;
        raster->effect_list = raster->blend->list;
    } else if (raster->blend == NULL) {
        raster->effect_row = raster->fog->stages->row;
        raster->effect_list = raster->fog->stages->list;
    }
}

const qtri_effect_stages qtri_effects = {apply, qtri_line_effects, qtri_span_fill, choose,
                                         &qtri_list_late_effects};
