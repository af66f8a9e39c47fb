/* SPDX-License-Identifier: MIT */
#include "packed.h"

void qtri_packed_colors(uint32_t *color, const qtri_job *job, int32_t x, int32_t y, int32_t phase,
                        int32_t count)
{
    const qtri_packed_steps *step = &job->color.step;
    uint32_t packed = qtri_packed_start(job, x - phase - job->anchor_x, y - job->anchor_y) +
                      qtri_packed_skip(job, phase);
    const uint32_t even = step->even;
    const uint32_t odd = step->odd;
    const uint32_t last = step->last;
    do { /* phase is a multiple of 8 */
        for (int i = 0; i < 8; i += 4) {
            color[i] = qtri_packed_pixel(packed);
            packed += even;
            color[i + 1] = qtri_packed_pixel(packed);
            packed += odd;
            color[i + 2] = qtri_packed_pixel(packed);
            packed += even;
            color[i + 3] = qtri_packed_pixel(packed);
            packed += i == 0 ? odd : last;
        }
        color += 8;
    } while ((count -= 8) > 0);
}
