#include "fill_pairs.h"

#if QTRI_PAIRS

enum { LONG = 12 }; /* pixels from which pairs are worth the while */

/* A long span of one colour. */
static void flat_span(uint16_t *pixel, uint16_t *depth, int32_t count, uint32_t color, uint32_t z,
                      uint32_t step)
{
    const uint32_t pair = color << 16 | color;
    int32_t alone = (int32_t)((uintptr_t)pixel & 2) >> 1;
    count -= alone;
    for (; alone > 0; alone--) {
        if (z >> 16 < *depth) {
            *depth = (uint16_t)(z >> 16);
            *pixel = (uint16_t)color;
        }
        z += step;
        depth++;
        pixel++;
    }
    uint32_t next = z + step;
    const uint32_t two = 2 * step;
#define ONE(i)                                                                                     \
    qtri_pair_draw(pixel + 2 * (i), depth + 2 * (i), z, next, pair);                               \
    z += two;                                                                                      \
    next += two;                                                                                   \
    QTRI_OPAQUE(z)                                                                                 \
    QTRI_OPAQUE(next)
    for (; count >= 16; count -= 16) {
        ONE(0) ONE(1) ONE(2) ONE(3) ONE(4) ONE(5) ONE(6) ONE(7) QTRI_MOVE(16)
    }
    for (; count >= 2; count -= 2) {
        ONE(0)
        QTRI_MOVE(2)
    }
#undef ONE
    if (count > 0 && z >> 16 < *depth) {
        *depth = (uint16_t)(z >> 16);
        *pixel = (uint16_t)color;
    }
}

void qtri_fill_flat_pairs(const qtri_job *job, const qtri_span *spans, int32_t row, int32_t count)
{
    const qtri_raster *raster = job->raster;
    qtri_lines lines = qtri_lines_at(raster->surface, row);
    for (; count > 0; count--, spans++, row++) {
        int32_t x;
        int32_t rest = qtri_span_clip(spans, &raster->bounds, &x);
        if (rest > 0) {
            uint32_t z = qtri_ramp_at(&job->depth, x - job->anchor_x, row - job->anchor_y);
            uint16_t *pixel = (uint16_t *)(void *)lines.pixels + x;
            uint16_t *depth = lines.depths + x;
            if (rest >= LONG && qtri_pairs_fit(pixel, depth)) {
                flat_span(pixel, depth, rest, job->pixel, z, job->depth.dx);
            } else {
                const uint32_t step = job->depth.dx;
                const uint16_t color = (uint16_t)job->pixel;
                for (; rest > 0; rest--) {
                    if (z >> 16 < *depth) {
                        QTRI_BRANCH
                        *depth = (uint16_t)(z >> 16);
                        *pixel = color;
                    }
                    z += step;
                    depth++;
                    pixel++;
                }
            }
        }
        lines.pixels += raster->surface->pitch;
        lines.depths += raster->surface->depth_pitch;
    }
}

#else

typedef int qtri_no_pairs; /* a file of C is not empty */

#endif
