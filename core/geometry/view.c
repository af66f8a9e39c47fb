/* SPDX-License-Identifier: MIT */
/* Views: viewport, camera, projection, and jitter by parts of a pixel. */
#include "qtri/view.h"
#include "qtri/antialias.h"
#include "qtri/error.h"

#include <stddef.h>

#include "../bits/bits.h"

/* ---- Views ---- */

qtri_viewport qtri_viewport_top(int32_t x, int32_t y, int32_t width, int32_t height)
{
    qtri_viewport viewport = {x, y, width, height, 0, Q16_ONE};
    return viewport;
}

qtri_viewport qtri_viewport_bottom(int32_t x, int32_t y, int32_t width, int32_t height,
                                   int32_t frame_height)
{
    const int32_t top = qtri_saturate32((int64_t)frame_height - height - y);
    return qtri_viewport_top(x, qtri_hold32(top, -QTRI_VIEWPORT_MAX, QTRI_VIEWPORT_MAX), width,
                             height);
}

void qtri_view_init_pipelines(qtri_view *view, int32_t frame_width, int32_t frame_height,
                              const qtri_pipeline *const *pipelines)
{
    QTRI_ASSERT(view != NULL && pipelines != NULL);
    qtri_transform_identity(&view->camera);
    qtri_transform_identity(&view->projection);
    view->viewport = qtri_viewport_top(0, 0, frame_width, frame_height);
    view->light = NULL;
    view->vertices = NULL;
    view->vertex_count = 0;
    view->pipelines = pipelines;
}

void qtri_view_look_at(qtri_view *view, qtri_vec3 eye, qtri_vec3 center, qtri_vec3 up)
{
    QTRI_ASSERT(view != NULL);
    qtri_transform_identity(&view->camera);
    qtri_transform_look_at(&view->camera, eye, center, up);
}

void qtri_view_perspective(qtri_view *view, q16 fovy, q16 near_z, q16 far_z)
{
    QTRI_ASSERT(view != NULL);
    const qtri_viewport *viewport = &view->viewport;
    const q16 aspect =
        viewport->height == 0 ? Q16_ONE : q16_from_ratio(viewport->width, viewport->height);
    qtri_transform_identity(&view->projection);
    qtri_transform_perspective(&view->projection, fovy, aspect, near_z, far_z);
}

/* ---- Jitter ---- */

/* The lowest `count` bits in reverse order. */
static uint32_t reverse_bits(uint32_t bits, int32_t count)
{
    uint32_t result = 0;
    for (; count > 0; count--, bits >>= 1) {
        result = result << 1 | (bits & 1);
    }
    return result;
}

/* From a pixel's centre to the middle of its part `part` of 2^count, in clip coordinates. */
static q16 clip_of(uint32_t part, int32_t count, int32_t pixels)
{
    const int32_t middle = (int32_t)((2 * part + 1) << (15 - count)); /* Q16 */
    return pixels > 0 ? 2 * (middle - 0x8000) / pixels : 0;
}

void qtri_view_jitter(qtri_view *out, const qtri_view *view, uint32_t n, int32_t frames_log2)
{
    QTRI_ASSERT(out != NULL);
    QTRI_ASSERT(view != NULL);
    const int32_t count = qtri_hold32(frames_log2, 0, QTRI_JITTER_LOG2_MAX);
    const uint32_t column = n & (((uint32_t)1 << count) - 1);
    const uint32_t row = reverse_bits(column, count) ^ (count > 0 ? 1 : 0);
    qtri_transform moved;
    const qtri_vec3 by = {clip_of(column, count, view->viewport.width),
                          clip_of(row, count, view->viewport.height), 0};
    qtri_transform_identity(&moved);
    qtri_transform_translate(&moved, by);
    *out = *view;
    qtri_transform_mul(&out->projection, &moved, &view->projection);
}
