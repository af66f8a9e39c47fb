/* SPDX-License-Identifier: MIT */
#include "packed.h"

#include "../frame/barrier.h"

void qtri_packed_colors(uint32_t *color, const qtri_job *job, int32_t x, int32_t y, int32_t phase,
                        int32_t count)
{
    const qtri_packed_steps *step = &job->color.step;
    uint32_t packed = qtri_packed_start(job, x - phase - job->anchor_x, y - job->anchor_y) +
                      qtri_packed_skip(job, phase);
    const uint32_t even = step->even;
    const uint32_t odd = step->odd;
    const uint32_t last = step->last;
    uint32_t mask = 0xF81F07E0u;
    QTRI_OPAQUE(mask)
#define ONE(i, step)                                                                               \
    {                                                                                              \
        const uint32_t shown = packed & mask;                                                      \
        color[i] = shown | shown >> 16;                                                            \
        packed += (step);                                                                          \
        QTRI_OPAQUE(packed)                                                                        \
    }
    do { /* phase is a multiple of 8 */
        ONE(0, even)
        ONE(1, odd)
        ONE(2, even)
        ONE(3, odd)
        ONE(4, even)
        ONE(5, odd)
        ONE(6, even)
        ONE(7, last)
        color += 8;
        QTRI_OPAQUE(color)
    } while ((count -= 8) > 0);
#undef ONE
}
