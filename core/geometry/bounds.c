/* SPDX-License-Identifier: MIT */
/*
 * What encloses a mesh, and whether a projector or a view can see it.
 */
#include "qtri/bounds.h"

#include <stddef.h>

#include "qtri/error.h"

#include "../bits/bits.h"
#include "projector.h"

/* Position i, rounded down or up to Q16.16 on all axes. */
static qtri_vec3 position_of(const qtri_mesh *mesh, uint32_t i, bool is_up)
{
    if (mesh->positions16 == NULL) {
        return mesh->positions[i];
    }
    const qtri_position16 *p = &mesh->positions16[i];
    const int64_t up = is_up ? 32767 : 0;
    const qtri_vec3 v = {
        qtri_saturate32(mesh->origin.x + ((qtri_mul_s32(mesh->extent, p->x) + up) >> 15)),
        qtri_saturate32(mesh->origin.y + ((qtri_mul_s32(mesh->extent, p->y) + up) >> 15)),
        qtri_saturate32(mesh->origin.z + ((qtri_mul_s32(mesh->extent, p->z) + up) >> 15))};
    return v;
}

static uint32_t count_of(const qtri_mesh *mesh)
{
    return mesh->positions16 != NULL || mesh->positions != NULL ? mesh->vertex_count : 0;
}

/*
 * Half of what lies between, rounded up, and the middle, rounded down: where one is rounded the
 * other is, too, so that they reach `high` exactly and `low` at least. Only from the lowest to the
 * highest number half does not fit, and is held one below.
 */
static void set_axis(q16 *center, q16 *half, q16 low, q16 high)
{
    const int64_t sum = (int64_t)low + high;
    *center = (q16)(sum >> 1);
    *half = qtri_saturate32((((int64_t)high - low) + 1) >> 1);
}

qtri_box qtri_mesh_box(const qtri_mesh *mesh)
{
    QTRI_ASSERT(mesh != NULL);
    static const qtri_box empty = {{0, 0, 0}, {0, 0, 0}};
    const uint32_t count = count_of(mesh);
    if (count == 0) {
        return empty;
    }
    qtri_vec3 low = position_of(mesh, 0, false);
    qtri_vec3 high = position_of(mesh, 0, true);
    for (uint32_t i = 1; i < count; i++) {
        const qtri_vec3 down = position_of(mesh, i, false);
        const qtri_vec3 up = position_of(mesh, i, true);
        low.x = qtri_least32(low.x, down.x);
        low.y = qtri_least32(low.y, down.y);
        low.z = qtri_least32(low.z, down.z);
        high.x = qtri_greatest32(high.x, up.x);
        high.y = qtri_greatest32(high.y, up.y);
        high.z = qtri_greatest32(high.z, up.z);
    }
    qtri_box box;
    set_axis(&box.center.x, &box.half.x, low.x, high.x);
    set_axis(&box.center.y, &box.half.y, low.y, high.y);
    set_axis(&box.center.z, &box.half.z, low.z, high.z);
    return box;
}

/* |a - b|, below 2^32. */
static uint32_t apart(q16 a, q16 b)
{
    return (uint32_t)qtri_magnitude64((int64_t)a - b);
}

/* The greater of the distances of the position's two roundings from the centre, squared / 4. */
static uint64_t distance_squared(const qtri_vec3 *center, const qtri_vec3 *a, const qtri_vec3 *b)
{
    const uint32_t d[3] = {apart(a->x, center->x), apart(a->y, center->y), apart(a->z, center->z)};
    const uint32_t e[3] = {apart(b->x, center->x), apart(b->y, center->y), apart(b->z, center->z)};
    uint64_t sum = 0;
    for (int i = 0; i < 3; i++) { /* halves rounded up, <= 2^31: three squares below 2^64 */
        const uint32_t half = ((d[i] > e[i] ? d[i] : e[i]) >> 1) + 1;
        sum += qtri_mul_u32(half, half);
    }
    return sum;
}

qtri_ball qtri_mesh_ball(const qtri_mesh *mesh)
{
    const qtri_box box = qtri_mesh_box(mesh);
    const uint32_t count = count_of(mesh);
    uint64_t most = 0;
    for (uint32_t i = 0; i < count; i++) {
        const qtri_vec3 down = position_of(mesh, i, false);
        const qtri_vec3 up = position_of(mesh, i, true);
        const uint64_t square = distance_squared(&box.center, &down, &up);
        most = square > most ? square : most;
    }
    qtri_ball ball = {box.center, 0};
    if (count > 0) {
        ball.radius = qtri_saturate32((int64_t)(2 * (qtri_sqrt64_round(most) + 1)));
    }
    return ball;
}

/* What all corners of a box lie outside of: the near and far plane and the sides of a rectangle. */
enum { SIDES = 6 };

/*
 * Below zero outside, in units of 2^18: |x| < 2^43 and |edge| <= 2^15, so that 64 bits have room.
 * Cutting the low bits off moves a side by less than |edge| + 2 units.
 */
static int64_t beyond(int64_t x, int64_t w, int32_t edge)
{
    int32_t slack = (edge < 0 ? -edge : edge) + 2;
    return edge * w - x + slack;
}

/*
 * A half space of homogeneous coordinates that holds the corners holds the box; what is seen of it
 * has w > 0, and x / w beyond the edge. Edges are moved out by a pixel, for lines on them.
 */
bool qtri_projector_misses(const qtri_projector *projector, const qtri_box *box,
                           const int32_t low[2], const int32_t high[2])
{
    unsigned outside = (1u << SIDES) - 1;
    for (int i = 0; i < 8 && outside != 0; i++) {
        const qtri_vec3 *center = &box->center;
        const qtri_vec3 *half = &box->half;
        const qtri_vec3 corner = {
            (i & 1) != 0 ? q16_add(center->x, half->x) : q16_sub(center->x, half->x),
            (i & 2) != 0 ? q16_add(center->y, half->y) : q16_sub(center->y, half->y),
            (i & 4) != 0 ? q16_add(center->z, half->z) : q16_sub(center->z, half->z)};
        qtri_clip_vertex v;
        qtri_projector_point(projector, &corner, &v);
        int64_t x = v.x >> 18;
        int64_t y = v.y >> 18;
        int64_t z = v.z >> 18;
        int64_t w = v.w >> 18;
        const int64_t side[SIDES] = {beyond(-z, w, 1),          beyond(z, w, 1),
                                     beyond(-x, w, 1 - low[0]), beyond(x, w, high[0] + 1),
                                     beyond(-y, w, 1 - low[1]), beyond(y, w, high[1] + 1)};
        for (int k = 0; k < SIDES; k++) {
            outside &= side[k] < 0 ? ~0u : ~(1u << k);
        }
    }
    return outside != 0;
}

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
