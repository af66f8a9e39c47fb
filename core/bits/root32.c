/* SPDX-License-Identifier: MIT */
#include "bits.h"

#include "seed.h"

/*
 * x is normalised by an even number of zeros to m, whose root is in [2^15, 2^16). The seed's y is
 * 1 / sqrt(m) in Q31 within 2^-13 of itself, so that s is the root less e with |e| < 9; m - s^2 =
 * e (2 sqrt(m) - e), times y / 2^17, is e to within .005, and 1/32 more makes s the root rounded
 * down or 1 more, as in qtri_sqrt64_floor(). The root of m rounded down has the root of x rounded
 * down as its upper bits.
 */
uint32_t qtri_sqrt32_round(uint32_t x)
{
    if (x == 0) {
        return 0;
    }
    const int32_t zeros = qtri_clz32(x) & ~1;
    const uint32_t m = x << zeros;
    const uint32_t y_q15 = qtri_rsqrt_seed_in_place(m >> 16);
    uint32_t s = ((m >> 16) * y_q15) >> 15;
    const int32_t step = ((int32_t)(m - s * s) >> 5) * (int32_t)y_q15; /* < 2^(20 - 5 + 16) */
    s += (uint32_t)((step + ((int32_t)1 << 22)) >> 27);
    s -= (uint32_t)((int32_t)(m - s * s) < 0);
    const uint32_t root = s >> (zeros >> 1);
    return root + (x - root * root > root); /* x > (root + 1/2)^2 = root^2 + root + 1/4 */
}
