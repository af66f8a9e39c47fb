/* SPDX-License-Identifier: MIT */
#include "qtri/bounds.h"
#include "qtri/error.h"

#include "../bits/bits.h"
#include "projector.h"

bool qtri_view_sees_box(const qtri_view *view, const qtri_transform *pose, const qtri_box *box)
{
    QTRI_ASSERT(view != NULL);
    QTRI_ASSERT(pose != NULL);
    QTRI_ASSERT(box != NULL);
    QTRI_ASSERT(box->half.x >= 0 && box->half.y >= 0 && box->half.z >= 0);
    qtri_transform to_clip;
    qtri_projector projector;
    const qtri_viewport *viewport = &view->viewport;
    qtri_transform_mul(&to_clip, &view->camera, pose);
    qtri_transform_mul(&to_clip, &view->projection, &to_clip);
    qtri_projector_init(&projector, &to_clip, viewport);
    const int32_t limit = QTRI_VIEWPORT_MAX;
    const int32_t low[2] = {qtri_hold32(viewport->x, -limit, limit),
                            qtri_hold32(viewport->y, -limit, limit)};
    const int32_t high[2] = {low[0] + qtri_hold32(viewport->width, 0, limit),
                             low[1] + qtri_hold32(viewport->height, 0, limit)};
    return !qtri_projector_misses(&projector, box, low, high);
}

/* By the box around it, in object space: that of a turned ball is as good as any. */
bool qtri_view_sees_ball(const qtri_view *view, const qtri_transform *pose, const qtri_ball *ball)
{
    QTRI_ASSERT(ball != NULL);
    QTRI_ASSERT(ball->radius >= 0);
    const qtri_box box = {ball->center, {ball->radius, ball->radius, ball->radius}};
    return qtri_view_sees_box(view, pose, &box);
}
