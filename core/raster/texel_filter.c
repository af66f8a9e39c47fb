/* SPDX-License-Identifier: MIT */
/* What is between four texels with alpha. */
#include "qtri/body/state.h"

#include "../bits/bits.h"

/* Shares of a pixel's texels, of their sum, times how opaque they are: 2^30 at most in all. */
typedef struct shares {
    uint32_t of[4], sum;
} shares;

static void set_shares(shares *s, const uint32_t tap[4], uint32_t weight)
{
    const uint32_t along = weight & 2047;
    const uint32_t across = weight >> 16;
    s->of[3] = along * across;
    s->of[1] = (along << 11) - s->of[3];
    s->of[2] = (across << 11) - s->of[3];
    s->of[0] = ((uint32_t)1 << 22) - (along << 11) - s->of[2];
    s->sum = 0;
    for (int i = 0; i < 4; i++) {
        s->of[i] *= tap[i] >> 24;
        s->sum += s->of[i];
    }
}

/*
 * Colours weighted by how opaque they are, so that what is not seen lends no colour. Shares are cut
 * to 16 bits of their sum, which is then divided by as it is: off by .03 of a step of 255, and by
 * .01 for the quotient.
 */
static uint32_t mean_of(const uint32_t tap[4], uint32_t weight)
{
    shares s;
    uint32_t channel[3] = {0, 0, 0};
    uint32_t sum = 0; /* 2^15 - 3 .. 2^16 - 1 */
    set_shares(&s, tap, weight);
    if (s.sum == 0) {
        return 0;
    }
    const int32_t zeros = qtri_clz32(s.sum);
    for (int i = 0; i < 4; i++) {
        const uint32_t share = s.of[i] << zeros >> 16;
        sum += share;
        channel[0] += share * (tap[i] >> 16 & 255);
        channel[1] += share * (tap[i] >> 8 & 255);
        channel[2] += share * (tap[i] & 255);
    }
    const uint32_t odd = sum < 0x8000u;
    const uint32_t inverse = qtri_reciprocal_q31(sum << odd) << (1 + odd); /* 2^32 / sum */
    uint32_t color = (s.sum + ((uint32_t)1 << 21)) >> 22;
    for (int i = 0; i < 3; i++) {
        const uint32_t c_q8 = qtri_mul_high32(channel[i] << 8, inverse); /* 255.5 at most */
        color = color << 8 | (c_q8 + 128) >> 8;
    }
    return color;
}

/* The same of texels that are as opaque as each other. */
static uint32_t plain_mean_of(const uint32_t tap[4], uint32_t weight)
{
    const uint32_t along = weight & 2047;
    const uint32_t across = weight >> 16;
    uint32_t color = tap[0] >> 24;
    for (int shift = 16; shift >= 0; shift -= 8) {
        const uint32_t c[4] = {tap[0] >> shift & 255, tap[1] >> shift & 255, tap[2] >> shift & 255,
                               tap[3] >> shift & 255};
        const uint32_t above = c[0] * (2048 - along) + c[1] * along;
        const uint32_t below = c[2] * (2048 - along) + c[3] * along;
        const uint32_t both = above * (2048 - across) + below * across; /* < 2^30 */
        color = color << 8 | (both + ((uint32_t)1 << 21)) >> 22;
    }
    return color;
}

uint32_t qtri_alpha_mean(const uint32_t texel[4], uint32_t along, uint32_t across)
{
    const uint32_t differ = (texel[0] ^ texel[1]) | (texel[0] ^ texel[2]) | (texel[0] ^ texel[3]);
    const uint32_t weight = across << 16 | along;
    return differ >> 24 == 0 ? plain_mean_of(texel, weight) : mean_of(texel, weight);
}
