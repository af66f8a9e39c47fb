/* SPDX-License-Identifier: MIT */
#include "qtri/bounds.h"
#include "qtri/error.h"

#include <stddef.h>

#include "../bits/bits.h"

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
