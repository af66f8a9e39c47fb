#include "../raster/loop.h"
#include "fused.h"

/* A pixel is a load, a compare, two stores and an addition. */
QTRI_IN_PLACE void fill(const qtri_job *job, const qtri_span *spans, int32_t row, int32_t count,
                        bool equal)
{
    const qtri_raster *raster = job->raster;
    qtri_lines lines = qtri_lines_at(raster->surface, row);
    for (const qtri_span *end = spans + count; spans < end; spans++, row++) {
        int32_t x;
        int32_t rest = qtri_span_clip(spans, &raster->bounds, &x);
        if (rest > 0) {
            uint16_t *pixel = (uint16_t *)(void *)lines.pixels + x;
            uint16_t *depth = lines.depths + x;
            uint32_t z = qtri_ramp_at(&job->depth, x - job->anchor_x, row - job->anchor_y);
            const uint32_t step = job->depth.dx;
            const uint16_t color = (uint16_t)job->pixel;
#define ONE(i)                                                                                     \
    if (qtri_passes(z >> 16, depth[i], equal)) {                                                   \
        QTRI_BRANCH                                                                                \
        depth[i] = (uint16_t)(z >> 16);                                                            \
        pixel[i] = color;                                                                          \
    }                                                                                              \
    z += step;                                                                                     \
    QTRI_OPAQUE(z)
            QTRI_PIXELS(rest)
#undef ONE
        }
        QTRI_READ_AGAIN
        lines.pixels += raster->surface->pitch;
        lines.depths += raster->surface->depth_pitch;
    }
}

void qtri_flat_less(const qtri_job *job, const qtri_span *spans, int32_t row, int32_t count)
{
    fill(job, spans, row, count, false);
}

#ifndef __OPTIMIZE_SIZE__
void qtri_flat_lequal(const qtri_job *job, const qtri_span *spans, int32_t row, int32_t count)
{
    fill(job, spans, row, count, true);
}
#endif
