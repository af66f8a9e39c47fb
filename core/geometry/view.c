/* SPDX-License-Identifier: MIT */
#include "qtri/view.h"

#include <stddef.h>

#include "qtri/error.h"

qtri_viewport qtri_viewport_top(int32_t x, int32_t y, int32_t width, int32_t height)
{
    qtri_viewport viewport = {x, y, width, height, 0, Q16_ONE};
    return viewport;
}

qtri_viewport qtri_viewport_bottom(int32_t x, int32_t y, int32_t width, int32_t height,
                                   int32_t frame_height)
{
    int64_t top = (int64_t)frame_height - height - y;
    if (top > QTRI_VIEWPORT_MAX) {
        top = QTRI_VIEWPORT_MAX;
    } else if (top < -QTRI_VIEWPORT_MAX) {
        top = -QTRI_VIEWPORT_MAX;
    }
    return qtri_viewport_top(x, (int32_t)top, width, height);
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
    view->lights = NULL;
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
