/* SPDX-License-Identifier: MIT */
/*
 * Animation: keyframes of poses, hierarchies of transforms, and morphs of meshes.
 */
#include "qtri/animation.h"
#include "qtri/error.h"

#include <stddef.h>

#include "../bits/bits.h"
#include "../math/unit.h"
#include "plain.h"

/* ---- Keys ---- */

/* a + (b - a) t, rounded, for 0 <= t <= 1: |b - a| < 2^32, and with the half below 2^63. */
static q16 lerp_q31(q16 a, q16 b, uint32_t t_q31)
{
    return (q16)(a + ((((int64_t)b - a) * t_q31 + 0x40000000) >> 31));
}

static qtri_vec3 lerp3(const qtri_vec3 *a, const qtri_vec3 *b, uint32_t t_q31)
{
    const qtri_vec3 v = {lerp_q31(a->x, b->x, t_q31), lerp_q31(a->y, b->y, t_q31),
                         lerp_q31(a->z, b->z, t_q31)};
    return v;
}

/* (time - from) / (to - from) for from <= time < to, rounded; differences are below 2^32. */
static uint32_t key_fraction_q31(q16 from, q16 to, q16 time)
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
    const uint32_t t_q31 = key_fraction_q31(a->time, b->time, time);
    const qtri_key key = {
        time, lerp3(&a->position, &b->position, t_q31),
        qtri_quat_slerp(a->orientation, b->orientation, (q16)((t_q31 + 0x4000) >> 15)),
        lerp3(&a->scale, &b->scale, t_q31)};
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

/* ---- Hierarchies ---- */

void qtri_poses_compose(qtri_transform *world, const qtri_transform *local, const int16_t *parent,
                        int32_t count)
{
    QTRI_ASSERT((world != NULL && local != NULL && parent != NULL) || count <= 0);
    for (int32_t i = 0; i < count; i++) {
        if (parent[i] >= 0 && parent[i] < i) {
            qtri_transform_mul(&world[i], &world[parent[i]], &local[i]);
        } else {
            world[i] = local[i];
        }
    }
}

/* ---- Morphs ---- */

/* a + (b - a) t, rounded: (2^16 - 1) 2^16 + 2^15 < 2^32, as an unsigned sum that does not wrap. */
static int16_t lerp_position(int16_t a, int16_t b, uint32_t t)
{
    const int32_t d = b - a;
    const uint32_t way = (qtri_magnitude32(d) * t + 0x8000u) >> 16;
    return (int16_t)(d < 0 ? a - (int32_t)way : a + (int32_t)way);
}

void qtri_morph_positions(qtri_position16 *out, const qtri_position16 *from,
                          const qtri_position16 *to, uint32_t count, q16 t)
{
    QTRI_ASSERT((out != NULL && from != NULL && to != NULL) || count == 0);
    const uint32_t part = (uint32_t)q16_clamp(t, 0, Q16_ONE);
    for (uint32_t i = 0; i < count; i++) {
        const qtri_position16 p = {lerp_position(from[i].x, to[i].x, part),
                                   lerp_position(from[i].y, to[i].y, part),
                                   lerp_position(from[i].z, to[i].z, part)};
        out[i] = p;
    }
}

#ifdef QTRI_CHECKED
static void check_targets(const qtri_position16 *const *target, int32_t targets, uint32_t count)
{
    for (int32_t k = 0; k < targets; k++) {
        QTRI_ASSERT(target[k] != NULL || count == 0);
    }
}
#endif

void qtri_morph_targets(qtri_position16 *out, const qtri_position16 *base,
                        const qtri_position16 *const *target, const q16 *weight, int32_t targets,
                        uint32_t count)
{
    QTRI_ASSERT((out != NULL && base != NULL) || count == 0);
    QTRI_ASSERT((target != NULL && weight != NULL) || targets <= 0);
    QTRI_CHECK(check_targets(target, targets, count));
    for (uint32_t i = 0; i < count; i++) {
        const int16_t p[3] = {base[i].x, base[i].y, base[i].z};
        int64_t sum[3]; /* each target adds less than 2^47 */
        for (int k = 0; k < 3; k++) {
            sum[k] = (int64_t)p[k] * 65536;
        }
        for (int32_t n = 0; n < targets; n++) {
            const int16_t q[3] = {target[n][i].x, target[n][i].y, target[n][i].z};
            for (int k = 0; k < 3; k++) {
                const int64_t most = (int64_t)1 << 60; /* held: far beyond any result */
                sum[k] += qtri_mul_s32(weight[n], q[k] - p[k]);
                sum[k] = sum[k] > most ? most : (sum[k] < -most ? -most : sum[k]);
            }
        }
        int16_t held[3];
        for (int k = 0; k < 3; k++) {
            held[k] = (int16_t)qtri_hold32(qtri_saturate32((sum[k] + 0x8000) >> 16), -32767, 32767);
        }
        const qtri_position16 result = {held[0], held[1], held[2]};
        out[i] = result;
    }
}

void qtri_frames_positions(qtri_position16 *out, const qtri_position16 *positions, int32_t frames,
                           uint32_t count, q16 at)
{
    QTRI_ASSERT((out != NULL && positions != NULL) || count == 0 || frames < 1);
    QTRI_ASSERT(frames <= 32767);
    if (frames < 1) {
        return;
    }
    const int32_t number = frames < 32767 ? frames : 32767;
    const q16 place = q16_mod(at, number * 65536);
    const uint32_t from = (uint32_t)place >> 16;
    const uint32_t to = from + 1 < (uint32_t)number ? from + 1 : 0;
    qtri_morph_positions(out, positions + (size_t)from * count, positions + (size_t)to * count,
                         count, place & 0xFFFF);
}

/* 127 v, rounded, for a component of a unit vector in Q2.30. */
static int8_t to_q7(int32_t v_q30)
{
    return (int8_t)(((v_q30 >> 8) * 127 + ((int32_t)1 << 21)) >> 22); /* |.| <= 2^22 127 < 2^29 */
}

/* a (1 - t) + b t in Q16: |.| <= 127 2^16. */
static int32_t lerp_normal(int8_t a, int8_t b, int32_t t)
{
    return a * (Q16_ONE - t) + b * t;
}

void qtri_morph_normals(qtri_normal8 *out, const qtri_normal8 *from, const qtri_normal8 *to,
                        uint32_t count, q16 t)
{
    QTRI_ASSERT((out != NULL && from != NULL && to != NULL) || count == 0);
    const q16 part = q16_clamp(t, 0, Q16_ONE);
    for (uint32_t i = 0; i < count; i++) {
        int32_t v[3] = {lerp_normal(from[i].x, to[i].x, part),
                        lerp_normal(from[i].y, to[i].y, part),
                        lerp_normal(from[i].z, to[i].z, part)};
        qtri_normal8 normal = from[i];
        if (qtri_unit(v, v, 3, 30)) {
            normal.x = to_q7(v[0]);
            normal.y = to_q7(v[1]);
            normal.z = to_q7(v[2]);
        }
        out[i] = normal;
    }
}
