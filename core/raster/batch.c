/* SPDX-License-Identifier: MIT */
#include "batch.h"

int32_t qtri_batch_keep(qtri_batch *batch, const qtri_surface *surface, const qtri_ramp *depth,
                        uint32_t mask, int32_t count, bool write)
{
    int32_t kept = 0;
    mask <<= 32 - count;
    for (int32_t i = 0; mask != 0; i++, mask <<= 1) {
        if ((int32_t)mask >= 0) {
            continue;
        }
        const uint32_t place = batch->place[i];
        const uint32_t row = place >> 16;
        const uint32_t column = place & 0xFFFF;
        if (write) {
            const uint32_t z = depth->origin + column * depth->dx + row * depth->dy;
            surface->depth[(ptrdiff_t)row * surface->depth_pitch + (ptrdiff_t)column] =
                (uint16_t)(z >> 16);
        }
        batch->color[kept] = batch->color[i];
        batch->place[kept] = place;
        kept++;
    }
    return kept;
}
