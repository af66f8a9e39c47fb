/* SPDX-License-Identifier: MIT */
#include "qtri/animation.h"

#include "../bits/bits.h"
#include "../bits/checked.h"

/* a + (b - a) t, rounded, for 0 <= t <= 1: |b - a| t < 2^49. */
static q16 between(q16 a, q16 b, q16 t)
{
    return (q16)(a + ((((int64_t)b - a) * t + 0x8000) >> 16));
}

static qtri_vec3 between3(const qtri_vec3 *a, const qtri_vec3 *b, q16 t)
{
    const qtri_vec3 v = {between(a->x, b->x, t), between(a->y, b->y, t), between(a->z, b->z, t)};
    return v;
}

/* The part of the way that is done, 0..1; differences are below 2^32. */
static q16 part_done(q16 from, q16 to, q16 time)
{
    bool half;
    const uint64_t whole = (uint64_t)((int64_t)to - from);
    const uint64_t done = (uint64_t)((int64_t)time - from);
    const uint64_t part = qtri_divide64(done, whole, 16, &half);
    return (q16)(part + half);
}

#ifdef QTRI_CHECKED
static void check_times(const qtri_key *keys, int32_t count)
{
    for (int32_t i = 1; i < count; i++) {
        QTRI_ASSERT(keys[i].time >= keys[i - 1].time);
    }
}
#endif

qtri_key qtri_keys_at(const qtri_key *keys, int32_t count, q16 time)
{
    QTRI_ASSERT(keys != NULL || count <= 0);
    QTRI_CHECK(check_times(keys, count));
    if (count <= 0) {
        const qtri_key none = {time, {0, 0, 0}, {Q16_ONE, 0, 0, 0}, {Q16_ONE, Q16_ONE, Q16_ONE}};
        return none;
    }
    int32_t next = 0;
    while (next < count && keys[next].time <= time) {
        next++;
    }
    if (next == 0 || next == count) {
        qtri_key end = keys[next == 0 ? 0 : count - 1];
        end.time = time;
        return end;
    }
    const qtri_key *a = &keys[next - 1];
    const qtri_key *b = &keys[next];
    const q16 t = part_done(a->time, b->time, time);
    const qtri_key key = {time, between3(&a->position, &b->position, t),
                          qtri_quat_slerp(a->orientation, b->orientation, t),
                          between3(&a->scale, &b->scale, t)};
    return key;
}

void qtri_transform_key(qtri_transform *t, const qtri_key *key)
{
    QTRI_ASSERT(t != NULL);
    QTRI_ASSERT(key != NULL);
    qtri_transform_translate(t, key->position);
    qtri_transform_rotate_quat(t, key->orientation);
    qtri_transform_scale(t, key->scale);
}
