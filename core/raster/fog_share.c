/* SPDX-License-Identifier: MIT */
/* What fog leaves of a colour at a depth. */
#include "qtri/body/state.h"
#include "qtri/error.h"

#include "../bits/bits.h"

enum {
    OCTAVE_STEPS = 8 * 16,       /* and share[OCTAVE_STEPS] ends the last */
    LOWEST = QTRI_FOG_STEPS - 1, /* by octaves: the share where t is 0 */
    PART_BITS = 12               /* of a step, which are enough */
};

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

/* Between two shares, over 2^bits of t: 2^12 of 2^17, the rise being so, is below 2^30. */
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
