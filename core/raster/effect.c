/* SPDX-License-Identifier: MIT */
#include "effect.h"

#include "job.h"
#include "list_values.h"

static void add_fog(const qtri_raster *raster, uint32_t *color, const uint32_t *place,
                    const qtri_ramp *depth, int32_t count)
{
    uint16_t z[QTRI_BATCH];
    for (int32_t i = 0; i < count; i++) {
        z[i] = (uint16_t)(qtri_list_at(depth, place[i] & 0xFFFF, place[i] >> 16) >> 16);
    }
    raster->fog->stages->apply(raster->fog, raster->format, color, z, count, raster->wide);
}

static uint32_t apply(const qtri_raster *raster, uint32_t *color, const uint32_t *place,
                      const qtri_ramp *depth, uint32_t mask, int32_t count)
{
    if (raster->fog != NULL) {
        add_fog(raster, color, place, depth, count);
    }
    return raster->blend != NULL ? raster->blend->apply(raster, color, place, mask, count) : mask;
}

const qtri_effect_stages qtri_effects[1] = {{apply, qtri_span_fill}};
