/* SPDX-License-Identifier: MIT */
/* Fog by the distance from the eye: the table of its shares, and what is read from it. */
#include "qtri/body/state.h"
#include "qtri/material.h"

#include "../bits/bits.h"
#include "descriptions.h"

enum {
    STEPS = 8 * 16, /* step i is from share[i] to share[i + 1], 1..STEPS */
    PART_BITS = 12  /* of a step, which are enough */
};

static uint64_t quotient(uint64_t n, uint64_t divisor, int32_t more)
{
    bool half;
    return qtri_divide64(n, divisor, more, &half);
}

/* Distances of the planes, Q16: near_z >= 1, far_z > near_z. */
typedef struct fog_planes {
    uint64_t near_z, far_z;
} fog_planes;

static fog_planes planes_of(qtri_fog_range range)
{
    fog_planes planes;
    planes.near_z = (uint64_t)qtri_greatest32(range.near_z, 1);
    planes.far_z = range.far_z > (q16)planes.near_z ? (uint64_t)range.far_z : planes.near_z + 1;
    return planes;
}

/* All of t: 65535.0. */
#define WHOLE 0xFFFF0000u

/*
 * Distance from the eye's plane where the depth is t < 2^33 less than 65535.0; Q16. A far plane is
 * 2^31 away where the near one is 1 before. The last of equal steps ends before the near plane: its
 * share is that of there, for what is within the step to be right.
 */
static q16 distance_at(qtri_fog_range range, uint64_t t)
{
    const fog_planes p = planes_of(range);
    const uint64_t inside = t < WHOLE ? t : WHOLE;
    const uint64_t beyond = quotient(inside * (p.far_z - p.near_z), WHOLE, 0) + /* .. < 2^63 */
                            quotient((t - inside) * (p.far_z - p.near_z), WHOLE, 0);
    if (range.orthographic) {
        return qtri_saturate32((int64_t)(p.far_z - beyond));
    }
    return qtri_saturate32((int64_t)quotient(p.near_z * p.far_z, p.near_z + beyond, 0));
}

/* t, the depth's difference to 65535.0, at distance z: WHOLE at the near plane, 0 at the far. */
static uint32_t t_of(qtri_fog_range range, q16 z)
{
    const fog_planes p = planes_of(range);
    if (z <= (q16)p.near_z) {
        return WHOLE;
    }
    if (z >= (int64_t)p.far_z) {
        return 0;
    }
    uint64_t part = quotient(p.far_z - (uint64_t)z, p.far_z - p.near_z, 32); /* < 2^32 */
    if (!range.orthographic) {
        part = quotient(part * p.near_z, (uint64_t)z, 0);
    }
    return part < WHOLE ? (uint32_t)part : WHOLE;
}

static void set_shares(qtri_fog *fog, qtri_fog_range range, qtri_fog_law share, q16 a, q16 b)
{
    const int32_t most = (int32_t)31 << 16;
    for (int32_t i = 0; i < QTRI_FOG_STEPS; i++) {
        const int32_t step = qtri_greatest32(i - 1, 0); /* share[0]: where t is 0 */
        uint64_t t = i == 0 ? 0 : (uint64_t)(8 + (step & 7)) << ((step >> 3) + 13);
        if (fog->step_bits != 0) {
            t = fog->first + ((uint64_t)step << fog->step_bits);
        }
        t = t < 0x8000 ? 0 : t - 0x8000; /* t.. without its half */
        const int64_t f = share(distance_at(range, t), a, b);
        fog->share[i] = (int16_t)(((f < -most ? -most : (f > most ? most : (int32_t)f)) + 32) >> 6);
    }
}

void qtri_fog_set(qtri_fog *fog, qtri_fog_range range, q16 z0, q16 z1, qtri_fog_law share, q16 a,
                  q16 b)
{
    const uint32_t t0 = t_of(range, z1), t1 = t_of(range, z0);
    fog->is_set = true;
    fog->first = t0;
    fog->step_bits = 0;
    if (range.orthographic || t1 >> 2 <= t0) {
        fog->step_bits = 1;
        while (t1 > t0 && (t1 - t0 - 1) >> fog->step_bits >= STEPS) {
            fog->step_bits++;
        }
    }
    set_shares(fog, range, share, a, b);
}

/* What fog leaves of a colour -------------------------------------------------------------------
 */

/*
 * Shares are kept by t = ~depth, 16.16: 1/2 more than how far the depth is from 65535.0, for depths
 * come with the half that rounds. With perspective t is nearly 65535 near / z, so that eighths of
 * octaves are equally fine in z near and far; where only a small part of them would count, equal
 * steps are finer. Within a step, which has 2^*bits of t, a share is linear in t. The lowest *bits
 * of what *t becomes are its place in the step, 0 before the first and behind the last, where
 * shares do not change.
 */
QTRI_INLINE uint32_t find_step(const qtri_fog *fog, uint32_t *t, uint32_t *bits)
{
    *bits = fog->step_bits;
    if (*bits != 0) {
        const uint32_t inside = *t > fog->first ? *t - fog->first : 0;
        const uint32_t step = (inside >> *bits) + 1;
        *t = step > STEPS ? 0 : inside;
        return step > STEPS ? STEPS + 1 : step;
    }
    if (*t >> 16 == 0) {
        *bits = 16;
        return 0;
    }
    *bits = 28 - (uint32_t)qtri_clz32(*t); /* 13..28 */
    return (*bits - 13) * 8 + (*t >> *bits & 7) + 1;
}

#define FULL ((int32_t)1024 << PART_BITS) /* a share of 1 */

/* Of a step, before it is held to 0..FULL: 2^12 times a rise of at most 2^17 is below 2^30. */
QTRI_INLINE int32_t share_in_step(int32_t low, int32_t rise, uint32_t t, uint32_t bits)
{
    const int32_t part = (int32_t)(t << (32 - bits) >> (32 - PART_BITS));
    return low * (1 << PART_BITS) + (1 << (PART_BITS - 1)) + part * rise;
}

uint32_t qtri_fog_share(const qtri_fog *fog, uint32_t depth_16p16)
{
    uint32_t t = ~depth_16p16, bits;
    const uint32_t step = find_step(fog, &t, &bits);
    const int32_t low = fog->share[step];
    const int32_t share = share_in_step(low, fog->share[step + 1] - low, t, bits);
    return (uint32_t)qtri_hold32(share, 0, FULL) << (24 - 10 - PART_BITS);
}

uint32_t qtri_fog_along(uint32_t *step, const qtri_fog *fog, uint32_t z, uint32_t z_step,
                        uint32_t count)
{
    uint32_t t = ~z, bits;
    const uint32_t at = find_step(fog, &t, &bits), beyond = t - (count - 1) * z_step;
    const int32_t low = fog->share[at], high = fog->share[at + 1], rise = high - low;
    if ((t ^ beyond) >> bits == 0 && t != 0 && (uint32_t)low <= 1024 && (uint32_t)high <= 1024) {
        /* All in one step of the table, which holds no share back: 2^20 times a rise of 2^10. */
        *step = (uint32_t)(-rise * ((int32_t)(z_step << (31 - bits)) >> 11) >> 6);
        return ((uint32_t)share_in_step(low, rise, t, bits) << (24 - 10 - PART_BITS)) + 0x8000u;
    }
    const uint32_t first = qtri_fog_share(fog, z);
    *step = 0;
    if (count > 1) {
        const uint32_t last = qtri_fog_share(fog, z + (count - 1) * z_step);
        *step = (uint32_t)qtri_divide32((int32_t)(last - first), count - 1);
    }
    return first + 0x8000u;
}

void qtri_fog_find_stretch(qtri_fog_stretch *stretch, const qtri_fog *fog, uint32_t depth_16p16)
{
    const uint32_t t = ~depth_16p16;
    uint32_t in_step = t;
    const uint32_t step = find_step(fog, &in_step, &stretch->bits);
    const uint32_t last = ((uint32_t)1 << stretch->bits) - 1;
    stretch->low = fog->share[step];
    stretch->rise = fog->share[step + 1] - stretch->low;
    stretch->behind = in_step & last;
    stretch->ahead = last - stretch->behind;
    if (fog->step_bits != 0 && (t < fog->first || step > STEPS)) {
        stretch->rise = 0;
        stretch->behind = t < fog->first ? t : t - fog->first - ((uint32_t)STEPS << stretch->bits);
        stretch->ahead = t < fog->first ? fog->first - t : ~t;
    }
}
