/* SPDX-License-Identifier: MIT */
#include "list_late.h"

#include "list_values.h"

void qtri_list_note(const qtri_raster *raster, const qtri_ramp *depth, uint32_t mask, int32_t count)
{
    qtri_batch *batch = raster->batch;
    batch->mask = batch->mask << 1 << (count - 1) | (mask & qtri_mask_of(count));
    if (raster->keeps_depth) {
        const int32_t first = batch->count - count;
        const uint32_t *place = batch->place + first;
        uint32_t *to = batch->depth + first;
        const qtri_ramp r = *depth;
        for (const uint32_t *end = place + count; place != end; place++) {
            *to++ = qtri_list_at(&r, *place & 0xFFFF, *place >> 16);
        }
    }
}

int32_t qtri_list_keep(const qtri_raster *raster, int32_t first, uint32_t mask, int32_t count)
{
    const qtri_surface *surface = raster->surface;
    const uint32_t orders = qtri_orders_of(raster->compare);
    qtri_batch *batch = raster->batch;
    uint32_t *color = batch->color + first;
    uint32_t *place = batch->place + first;
    const uint32_t *depth = batch->depth + first;
    int32_t kept = 0;
    mask <<= 32 - count;
    for (int32_t i = 0; mask != 0; i++, mask <<= 1) {
        if ((int32_t)mask >= 0) {
            continue;
        }
        const uint32_t at = place[i];
        if (raster->depth_write) {
            uint16_t *stored = &surface->depth[(ptrdiff_t)(at >> 16) * surface->depth_pitch +
                                               (ptrdiff_t)(at & 0xFFFF)];
            if ((orders & qtri_order_of(depth[i] >> 16, *stored)) == 0) {
                continue;
            }
            *stored = (uint16_t)(depth[i] >> 16);
        }
        color[kept] = color[i];
        place[kept] = at;
        kept++;
    }
    return kept;
}

void qtri_list_store(const qtri_raster *raster, int32_t first, int32_t count)
{
    const qtri_surface *surface = raster->surface;
    const qtri_format *format = raster->format;
    uint32_t *color = raster->batch->color + first;
    if (format->encode != NULL) {
        format->encode(color, count);
    }
    format->pixels->scatter(surface->pixels, surface->pitch, raster->batch->place + first, color,
                            count);
}

static void store(const qtri_raster *raster, uint32_t mask, int32_t count)
{
    count = qtri_list_keep(raster, 0, mask, count);
    if (count != 0) {
        qtri_list_store(raster, 0, count);
    }
}

const qtri_list_late qtri_list_late_texels = {qtri_list_note, store};
