/* SPDX-License-Identifier: MIT */
#include "qtri/q16_exp.h"

#include "../bits/bits.h"
#include "../frame/mix.h"
#include "effect.h"
#include "stage_color.h"

#define OVER(c, o, k, most) qtri_mix_over(c, o, k)

enum { EVEN_STEPS = QTRI_FOG_STEPS - 2 };

/*
 * The share of a depth, by t = 65536 - depth. With perspective that is nearly 65536 near / z, so
 * that eighths of octaves are equally fine in z near and far; where only a small part of them would
 * count, equal steps are finer.
 */
static uint32_t share_at(const qtri_fog *fog, uint32_t depth)
{
    const uint32_t t = 65536 - depth; /* 1..65536 */
    uint32_t step;
    int32_t part; /* of a step, Q10 */
    if (fog->scale != 0) {
        const uint32_t from = t < fog->first ? 0 : t - fog->first;
        const uint32_t at = (from < fog->range ? from : fog->range) * fog->scale >> 12;
        step = at >> 10;
        part = (int32_t)(at & 1023);
    } else {
        const int32_t zeros = qtri_clz32(t | 1);
        const uint32_t mantissa = t << zeros << 1; /* without the leading bit */
        step = (uint32_t)(31 - zeros) * 8 + (mantissa >> 29);
        part = (int32_t)(mantissa >> 19 & 1023);
    }
    const int32_t low = fog->share[step];
    const int32_t share = low + (((fog->share[step + 1] - low) * part + 512) >> 10);
    return (uint32_t)qtri_hold32(share, 0, 1024);
}

static void apply(const qtri_fog *fog, const qtri_format *format, uint32_t *color,
                  const uint16_t *depth, int32_t count, bool wide)
{
    const qtri_colors *kind = wide ? &qtri_colors_888 : format->colors;
    const uint32_t gray = fog->word[wide || kind == &qtri_colors_888 ? 1
                                    : kind == &qtri_colors_565       ? 0
                                                                     : 2];
    QTRI_MIX(color, gray, count, kind, share_at(fog, depth[i]), OVER, qtri_mix_over_565)
}

static uint64_t quotient(uint64_t n, uint64_t divisor, int32_t more)
{
    bool half;
    return qtri_divide64(n, divisor, more, &half);
}

/* Distance from the eye's plane where 1 - depth is t / 65536, t 1..65536; Q16. */
static q16 distance_at(qtri_fog_range range, uint32_t t)
{
    const int64_t near_z = qtri_greatest32(range.near_z, 1);
    const int64_t far_z = range.far_z > near_z ? range.far_z : near_z + 1;
    const int64_t beyond = (int64_t)t * (far_z - near_z) / 65536; /* < 2^31 */
    if (range.orthographic) {
        return qtri_saturate32(far_z - beyond);
    }
    return qtri_saturate32(
        (int64_t)quotient((uint64_t)(near_z * far_z), (uint64_t)(near_z + beyond), 0));
}

/* The t of a distance. */
static uint32_t t_of(qtri_fog_range range, q16 z)
{
    const int64_t near_z = qtri_greatest32(range.near_z, 1);
    const int64_t far_z = range.far_z > near_z ? range.far_z : near_z + 1;
    if (z <= near_z) {
        return 65536;
    }
    if (z >= far_z) {
        return 1;
    }
    uint64_t part = quotient((uint64_t)(far_z - z), (uint64_t)(far_z - near_z), 30); /* < 2^30 */
    if (!range.orthographic) {
        part = quotient(part * (uint64_t)near_z, (uint64_t)z, 0);
    }
    const uint32_t t = (uint32_t)(part >> 14);
    return t < 1 ? 1 : t;
}

static const qtri_fog_stages stages = {qtri_effects, apply};

/* How the share, Q16, follows from the distance and two numbers. */
typedef int64_t (*law)(q16 z, q16 a, q16 b);

static void set_shares(qtri_fog *fog, qtri_fog_range range, law share, q16 a, q16 b)
{
    const int32_t most = (int32_t)31 << 16;
    for (int32_t i = 0; i < QTRI_FOG_STEPS; i++) {
        uint32_t t = ((uint32_t)(8 + (i & 7)) << (i >> 3)) >> 3;
        if (fog->scale != 0) {
            t = fog->first + fog->range * (uint32_t)i / EVEN_STEPS;
        }
        const int64_t f = share(distance_at(range, t > 65536 ? 65536 : (t < 1 ? 1 : t)), a, b);
        fog->share[i] = (int16_t)(((f < -most ? -most : (f > most ? most : (int32_t)f)) + 32) >> 6);
    }
}

/* Shares change between the distances z0 and z1. */
static void begin(qtri_fog *fog, qtri_rgb color, qtri_fog_range range, q16 z0, q16 z1)
{
    const uint32_t rgb = (uint32_t)color.r << 16 | (uint32_t)color.g << 8 | color.b;
    uint32_t word[4] = {rgb};
    fog->stages = &stages;
    fog->word[1] = rgb;
    qtri_888_to_565(word, 1);
    fog->word[0] = word[0];
    word[0] = rgb;
    qtri_888_to_gray(word, 1);
    fog->word[2] = word[0];
    const uint32_t t0 = t_of(range, z1);
    const uint32_t t1 = t_of(range, z0);
    fog->first = t0;
    fog->range = t1 > t0 ? t1 - t0 : 1;
    fog->scale = 0;
    if (range.orthographic || t1 < 4 * t0) {
        fog->scale = ((uint32_t)EVEN_STEPS << 22) / fog->range;
    }
}

static int64_t linear(q16 z, q16 start, q16 end)
{
    if (end <= start) {
        return z <= start ? Q16_ONE : 0;
    }
    const int64_t rest = (int64_t)end - z;
    const uint64_t share = quotient(qtri_magnitude64(rest), (uint64_t)((int64_t)end - start), 16);
    return rest < 0 ? -(int64_t)share : (int64_t)share;
}

static int64_t exponential(q16 z, q16 density, q16 unused)
{
    (void)unused;
    return q16_exp(-q16_mul(density, z));
}

static int64_t squared(q16 z, q16 density, q16 unused)
{
    const q16 x = q16_mul(density, z);
    (void)unused;
    return q16_exp(-q16_mul(x, x));
}

void qtri_fog_linear(qtri_fog *fog, qtri_rgb color, qtri_fog_range range, q16 start, q16 end)
{
    begin(fog, color, range, start, end);
    set_shares(fog, range, linear, start, end);
}

/* e^-8 is less than half of 1/1024. */
void qtri_fog_exp(qtri_fog *fog, qtri_rgb color, qtri_fog_range range, q16 density)
{
    density = qtri_greatest32(density, 0);
    begin(fog, color, range, 0, density == 0 ? INT32_MAX : q16_div((q16)8 * Q16_ONE, density));
    set_shares(fog, range, exponential, density, 0);
}

void qtri_fog_exp2(qtri_fog *fog, qtri_rgb color, qtri_fog_range range, q16 density)
{
    density = qtri_greatest32(density, 0);
    begin(fog, color, range, 0, density == 0 ? INT32_MAX : q16_div((q16)3 * Q16_ONE, density));
    set_shares(fog, range, squared, density, 0);
}
