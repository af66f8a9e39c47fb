/* SPDX-License-Identifier: MIT */
/* Fog by the distance from the eye: the table of its shares, and what is read from it. */
#include "qtri/body/state.h"
#include "qtri/material.h"

#include "../bits/bits.h"
#include "descriptions.h"

enum {
    OCTAVE_STEPS = 8 * 16,       /* and share[OCTAVE_STEPS] ends the last */
    LOWEST = QTRI_FOG_STEPS - 1, /* by octaves: the share where t is 0 */
    PART_BITS = 12               /* of a step, which are enough */
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
        uint64_t t = (uint64_t)(8 + (i & 7)) << ((i >> 3) + 13);
        if (fog->step_bits != 0) {
            t = fog->first + ((uint64_t)i << fog->step_bits);
        } else if (i == LOWEST) {
            t = 0;
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
        while (t1 > t0 && (t1 - t0 - 1) >> fog->step_bits >= OCTAVE_STEPS) {
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
 * steps are finer. Within a step a share is linear in t.
 */
typedef struct fog_step {
    uint32_t from, size; /* t */
    uint32_t shift;      /* (t - from) >> shift has at most PART_BITS bits */
    int32_t base, slope; /* base + that times the slope is 1024 2^PART_BITS where all is clear */
} fog_step;

/* From a share to the next over 2^bits of t: 2^12 times a rise of at most 2^17 is below 2^30. */
static void set_step(fog_step *s, int32_t low, int32_t high, uint32_t bits)
{
    const int32_t less = (int32_t)bits - PART_BITS;
    s->shift = less > 0 ? (uint32_t)less : 0;
    s->base = low * (1 << PART_BITS) + (1 << (PART_BITS - 1));
    s->slope = (high - low) * (less > 0 ? 1 : 1 << -less);
}

/* The step that t is in. */
QTRI_NOINLINE static void find_step(fog_step *s, const qtri_fog *fog, uint32_t t)
{
    const int16_t *share = fog->share;
    if (fog->step_bits != 0) {
        const uint32_t number = (t - fog->first) >> fog->step_bits;
        if (t < fog->first) {
            s->from = 0;
            s->size = fog->first;
            set_step(s, share[0], share[0], 0);
        } else if (number >= OCTAVE_STEPS) {
            s->from = t;
            s->size = 0 - t;
            set_step(s, share[OCTAVE_STEPS], share[OCTAVE_STEPS], 0);
        } else {
            s->from = fog->first + (number << fog->step_bits);
            s->size = (uint32_t)1 << fog->step_bits;
            set_step(s, share[number], share[number + 1], fog->step_bits);
        }
    } else if (t >> 16 == 0) {
        s->from = 0;
        s->size = 65536;
        set_step(s, share[LOWEST], share[0], 16);
    } else {
        const uint32_t zeros = (uint32_t)qtri_clz32(t); /* at most 15 */
        const uint32_t bits = 28 - zeros;
        const uint32_t number = (15 - zeros) * 8 + (t >> bits & 7);
        s->from = t >> bits << bits;
        s->size = (uint32_t)1 << bits;
        set_step(s, share[number], share[number + 1], bits);
    }
}

uint32_t qtri_fog_share(const qtri_fog *fog, uint32_t depth_16p16)
{
    fog_step s;
    const uint32_t t = ~depth_16p16;
    find_step(&s, fog, t);
    const int32_t share =
        s.base + (int32_t)((t - s.from) >> s.shift) * s.slope; /* 1024 2^12 is 1 */
    const int32_t full = (int32_t)1024 << PART_BITS;
    return (uint32_t)(share < 0 ? 0 : share > full ? full : share) << (24 - 10 - PART_BITS);
}
