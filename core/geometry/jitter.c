/* SPDX-License-Identifier: MIT */
#include "qtri/jitter.h"
#include "qtri/error.h"

#include "../bits/bits.h"

/* The lowest `count` bits the other way round. */
static uint32_t reversed(uint32_t bits, int32_t count)
{
    uint32_t result = 0;
    for (; count > 0; count--, bits >>= 1) {
        result = result << 1 | (bits & 1);
    }
    return result;
}

/* The middle of part `part` of 2^count of a pixel, Q16. */
static int32_t middle_of(uint32_t part, int32_t count)
{
    return (int32_t)((2 * part + 1) << (15 - count));
}

/* Clip coordinates of a part of a pixel, in the middle of -1/2 .. 1/2. */
static q16 clip_of(int32_t share, int32_t pixels)
{
    const int32_t half = 1 << 15;
    return pixels > 0 ? 2 * (share - half) / pixels : 0;
}

void qtri_view_jitter(qtri_view *out, const qtri_view *view, uint32_t n, int32_t frames_log2)
{
    QTRI_ASSERT(out != NULL);
    QTRI_ASSERT(view != NULL);
    const int32_t count = qtri_hold32(frames_log2, 0, QTRI_JITTER_LOG2_MAX);
    const uint32_t column = n & (((uint32_t)1 << count) - 1);
    const uint32_t row = reversed(column, count) ^ (count > 0 ? 1 : 0);
    qtri_transform moved;
    const qtri_vec3 by = {clip_of(middle_of(column, count), view->viewport.width),
                          clip_of(middle_of(row, count), view->viewport.height), 0};
    qtri_transform_identity(&moved);
    qtri_transform_translate(&moved, by);
    *out = *view;
    qtri_transform_mul(&out->projection, &moved, &view->projection);
}
