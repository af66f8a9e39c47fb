/* SPDX-License-Identifier: MIT */
#include "texel_axis.h"

#include "../bits/bits.h"

#define SIDE_LOG2_MAX 10

static int64_t hold_q32(int64_t coordinate)
{
    const int64_t limit = (int64_t)1 << 48;
    return coordinate < -limit ? -limit : (coordinate > limit ? limit : coordinate);
}

/* Added to values, so that those somewhat below 0 can be shifted; a multiple of the side. */
#define ABOVE_ZERO ((uint32_t)1 << 30)

void qtri_texel_axis_init(qtri_texel_axis *axis, uint32_t value[3], const int64_t coordinate_q32[3],
                          uint8_t side_log2, bool clamped, int32_t copy_shift)
{
    uint64_t offset[3];
    uint64_t all = 0;
    int32_t base = INT32_MAX; /* whole repeats below the least: |base| <= 2^16 */
    for (int i = 0; i < 3; i++) {
        int64_t held = hold_q32(coordinate_q32[i]);
        int32_t repeats = (int32_t)(held >> 32);
        base = repeats < base ? repeats : base;
        offset[i] = (uint64_t)held;
    }
    for (int i = 0; i < 3; i++) {
        offset[i] -= (uint64_t)(uint32_t)base << 32; /* 0..2^50; what is lost of the base wraps */
        all |= offset[i];
    }
    /* The span to below 2^30; at least 3 bits go, which leaves shift <= 29. */
    int32_t down = 34 - qtri_clz64(all);
    down = down < 3 ? 3 : down; /* <= 20 */
    for (int i = 0; i < 3; i++) {
        value[i] = (uint32_t)(offset[i] >> down);
    }
    side_log2 = side_log2 > SIDE_LOG2_MAX ? SIDE_LOG2_MAX : side_log2;
    const int32_t shift = 32 - down - side_log2;
    axis->shift = (uint8_t)shift;
    axis->side_log2 = side_log2;
    axis->clamped = clamped;
    axis->mask = (uint16_t)((1u << side_log2) - 1);
    axis->first = (int32_t)(ABOVE_ZERO >> shift) - base * ((int32_t)1 << side_log2);
    axis->bias = shift > 17 ? (uint32_t)1 << (shift - 16) : 2;
    axis->up = 0;
    axis->texel_shift = axis->shift;
    if (copy_shift != 0) {
        axis->up = (int8_t)(copy_shift - shift);
        axis->texel_shift = (uint8_t)copy_shift;
    } else {
        axis->bias += ABOVE_ZERO;
    }
}
