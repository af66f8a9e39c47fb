/* SPDX-License-Identifier: MIT */
#include "perspective_block.h"

void qtri_curve_set_steep(qtri_curve *out, const qtri_block *m, uint32_t value, int32_t l,
                          int32_t down)
{
    if (down > 22) {
        l >>= qtri_least32(down - 22, 31);
        down = 22;
    }
    const int32_t up = down < 0 ? -down : 0;
    down = down < 0 ? 0 : down;
    const int32_t l_15 = l >> 15;
    const int32_t to_start = (l + ((l_15 * m->value_q16) >> 1)) >> down;
    const int32_t step = (l + ((l_15 * m->step_q16) >> 1)) >> down;
    out->at = value - ((uint32_t)to_start << up) * (uint32_t)m->half;
    out->step = (uint32_t)step << up;
    out->bend = (uint32_t)((l_15 * m->bend_q15) >> (down + m->log2)) << up;
    out->twist = 0;
    if (m->twist_q12 != 0) { /* down + 2 log2 - 3 <= 27 */
        out->twist = (uint32_t)((l_15 * m->twist_q12) >> (down + 2 * m->log2 - 3)) << up;
    }
}

int32_t qtri_interpolate_perspective(qtri_scanline *row, int32_t x, int32_t count, int first,
                                     int end)
{
    const qtri_perspective *p = &row->job->color.perspective;
    qtri_block m;
    const int32_t length = qtri_block_begin(row, &m, first < QTRI_U ? p->colors : p->texels, x);
    if (!QTRI_SMALL_CODE && first == QTRI_U) {
        qtri_block_end(row, &m, QTRI_U, QTRI_ATTRIBUTES);
    } else {
        qtri_block_end(row, &m, first, end);
    }
    return qtri_least32(length, count);
}
