/* SPDX-License-Identifier: MIT */
#include "unit.h"

/* 128 / sqrt((i + 8.5) / 32): the reciprocal root in the middle of each 32nd from 1/4 to 1. */
static const uint8_t root_q7[24] = {248, 235, 223, 214, 205, 197, 190, 184, 178, 173, 168, 164,
                                    160, 156, 153, 149, 146, 143, 141, 138, 136, 133, 131, 129};

/*
 * 2^63 / sqrt(x 2^32), that is 1 / sqrt of x in Q32 as Q31, an even number, for x in [2^30, 2^32).
 * Newton: y <- y (3 - x y^2) / 2 turns a relative error e into -3/2 e^2. The table is within
 * 2^-4.9, so the steps leave 2^-9.2, 2^-17.8 and nothing but what the last one truncates, 2^-29,
 * which also keeps y below 2. Factors are doubled, for the high word of their product to be y.
 */
static uint32_t reciprocal_root_q31(uint32_t x)
{
    uint32_t guess_q7 = root_q7[(x >> 27) - 8];
    uint32_t near_one_q30 = (x >> 16) * (guess_q7 * guess_q7); /* < 2^16 1.14 2^14 */
    uint32_t y_q30 = guess_q7 * ((0xC0000000u - near_one_q30) >> 8);
    for (int step = 0; step < 2; step++) {
        uint32_t square_q29 = qtri_mul_high32(y_q30 << 1, y_q30);
        uint32_t factor_q30 = (0x60000000u - qtri_mul_high32(x, square_q29)) << 1;
        y_q30 = qtri_mul_high32(y_q30 << 1, factor_q30);
    }
    return y_q30 << 1;
}

bool qtri_unit(int32_t *out, const int32_t *v, int32_t count, int32_t fraction_bits)
{
    uint32_t size[4];
    uint32_t all = 0;
    for (int32_t i = 0; i < count; i++) {
        size[i] = qtri_magnitude32(v[i]);
        all |= size[i];
    }
    if (all == 0) {
        for (int32_t i = 0; i < count; i++) {
            out[i] = 0;
        }
        return false;
    }
    int32_t zeros = qtri_clz32(all);
    uint64_t square = 0;
    for (int32_t i = 0; i < count; i++) { /* below 2^31, the largest from 2^30 up: 2^60..2^64 */
        size[i] = size[i] << zeros >> 1;
        square += qtri_mul_u32(size[i], size[i]);
    }
    uint32_t high = (uint32_t)(square >> 32);
    int32_t shift = 31 - fraction_bits;
    if (high < 0x40000000u) {
        high = high << 2 | (uint32_t)(square & UINT32_MAX) >> 30;
        shift--;
    }
    uint32_t root_q31 = reciprocal_root_q31(high);
    /* Half of what the shift drops (of two bits and more), and of what goes before: an axis is
     * exact. */
    uint64_t half = (uint64_t)((uint32_t)1 << shift >> 2) << 33 | 0x80000000u;
    for (int32_t i = 0; i < count; i++) { /* product + half < 2^63 + 2^47 */
        int32_t unit =
            (int32_t)((uint32_t)((qtri_mul_u32(size[i], root_q31) + half) >> 32) >> shift);
        out[i] = v[i] < 0 ? -unit : unit;
    }
    return true;
}

int32_t qtri_fit32(int32_t *out, const int64_t *v, int32_t count)
{
    uint64_t all = 0;
    for (int32_t i = 0; i < count; i++) {
        all |= (uint64_t)(v[i] < 0 ? ~v[i] : v[i]);
    }
    int32_t k = 33 - qtri_clz64(all);
    k = k < 0 ? 0 : k;
    for (int32_t i = 0; i < count; i++) {
        out[i] = (int32_t)(v[i] >> k);
    }
    return k;
}

int32_t qtri_align32(int32_t out[3], const int64_t v[3], int32_t bits)
{
    const uint64_t all = qtri_magnitude64(v[0]) | qtri_magnitude64(v[1]) | qtri_magnitude64(v[2]);
    const int32_t k = 64 - bits - qtri_clz64(all | 1u);
    for (int i = 0; i < 3; i++) {
        out[i] = (int32_t)(k >= 0 ? v[i] >> k : qtri_shift_left64(v[i], -k));
    }
    return k;
}
