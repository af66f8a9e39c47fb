/* SPDX-License-Identifier: MIT */
#include "qtri/animation.h"

#include "../bits/bits.h"
#include "../bits/checked.h"
#include "plain.h"

/* a + (b - a) t, rounded, for 0 <= t <= 1: |b - a| < 2^32, and with the half below 2^63. */
static q16 between(q16 a, q16 b, uint32_t t_q31)
{
    return (q16)(a + ((((int64_t)b - a) * t_q31 + 0x40000000) >> 31));
}

static qtri_vec3 between3(const qtri_vec3 *a, const qtri_vec3 *b, uint32_t t_q31)
{
    const qtri_vec3 v = {between(a->x, b->x, t_q31), between(a->y, b->y, t_q31),
                         between(a->z, b->z, t_q31)};
    return v;
}

/* The part of the way that is done, 0..1; differences are below 2^32. */
static uint32_t part_done_q31(q16 from, q16 to, q16 time)
{
    bool half;
    const uint64_t whole = (uint64_t)((int64_t)to - from);
    const uint64_t done = (uint64_t)((int64_t)time - from);
    const uint64_t part = qtri_divide64(done, whole, 31, &half);
    return (uint32_t)part + half;
}

#ifdef QTRI_CHECKED
static void check_keys(const qtri_key *keys, int32_t count)
{
    for (int32_t i = 0; i < count; i++) {
        QTRI_ASSERT(i == 0 || keys[i].time >= keys[i - 1].time);
        QTRI_ASSERT(qtri_is_scale(keys[i].scale));
    }
}
#endif

qtri_key qtri_keys_at(const qtri_key *keys, int32_t count, q16 time)
{
    QTRI_ASSERT(keys != NULL || count <= 0);
    QTRI_CHECK(check_keys(keys, count));
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
    const uint32_t t_q31 = part_done_q31(a->time, b->time, time);
    const qtri_key key = {
        time, between3(&a->position, &b->position, t_q31),
        qtri_quat_slerp(a->orientation, b->orientation, (q16)((t_q31 + 0x4000) >> 15)),
        between3(&a->scale, &b->scale, t_q31)};
    return key;
}

void qtri_transform_key(qtri_transform *t, const qtri_key *key)
{
    QTRI_ASSERT(t != NULL);
    QTRI_ASSERT(key != NULL);
    qtri_transform_translate(t, key->position);
    qtri_transform_rotate_quat(t, key->orientation);
    qtri_transform_scale_any(t, key->scale);
}
