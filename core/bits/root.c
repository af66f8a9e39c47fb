/* SPDX-License-Identifier: MIT */
/*
 * Roots of integers.
 */

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

/*
 * floor(n / s) for s in [2^15, 2^16), n < (2^16 + 1) s, with y_q15 s within 2^-13 of 2^31. The
 * first estimate is within 11: 2^16 2^-13, 2 for the bits of n cut off, 1. What is left over times
 * y again is within 1/64; with 1/32 less it is never too much, and too little by 1 at most.
 */
static inline uint32_t quotient_by_root(uint32_t n, uint32_t s, uint32_t y_q15)
{
#if QTRI_DIVIDE
    (void)y_q15;
    return n / s;
#else
    uint32_t quotient = ((n >> 16) * y_q15) >> 15;
    int32_t rest = (int32_t)(n - quotient * s);                               /* < 2^20 */
    int32_t step = ((rest >> 6) * (int32_t)y_q15 - ((int32_t)1 << 20)) >> 25; /* 31 bits */
    quotient += (uint32_t)step;
    return quotient + (n - quotient * s >= s);
#endif
}

/*
 * The remainder is x less the root's square.
 *
 * x is normalised by an even number of zeros; m is its upper half, r its root. The seed, and so
 * v y 2^16, is r less e with |e| < 9; m - s^2 = e (2 r - e), times y / 2^17, adds e to within .005,
 * and 1/32 more makes s floor(r) or floor(r) + 1.
 *
 * As in long division, m - s^2 with 16 more bits of x, over 2 s, gives q, the lower half of the
 * root. s 2^16 + q is not less than it by the definition of q, and more by 1 at most as q^2 < 2^32
 * (Zimmermann, Karatsuba Square Root, 1999). Without the zeros' half the same holds.
 */
uint32_t qtri_sqrt64_floor(uint64_t x, uint64_t *remainder)
{
    if (x == 0) {
        *remainder = 0;
        return 0;
    }
    int32_t zeros = qtri_clz64(x) & ~1;
    uint64_t normal = x << zeros;
    uint32_t m = (uint32_t)(normal >> 32);
    uint32_t y_q15 = qtri_rsqrt_seed(m >> 16);
    uint32_t s = ((m >> 16) * y_q15) >> 15;                      /* within 8 */
    int32_t step = ((int32_t)(m - s * s) >> 5) * (int32_t)y_q15; /* < 2^(20 - 5 + 16) */
    s += (uint32_t)((step + ((int32_t)1 << 22)) >> 27);          /* floor(sqrt(m)) or 1 more */
    uint32_t short_by = m - s * s;
    if ((int32_t)short_by < 0) {
        s--;
        short_by += 2 * s + 1; /* <= 2 s */
    }
    uint32_t half = (short_by << 15) | ((uint32_t)(normal & UINT32_MAX) >> 17);
    uint32_t low = quotient_by_root(half, s, y_q15);
    uint32_t root = ((s << 16) + (low < 0xFFFFu ? low : 0xFFFFu)) >> (zeros >> 1);

    uint64_t rest = x - qtri_mul_u32(root, root); /* modulo 2^64 */
    if (rest >> 63 != 0) {
        root--;
        rest += 2 * (uint64_t)root + 1;
    }
    *remainder = rest;
    return root;
}

uint64_t qtri_sqrt64_round(uint64_t x)
{
    uint64_t rest;
    uint32_t root = qtri_sqrt64_floor(x, &rest);
    return (uint64_t)root + (rest > root); /* x > (root + 1/2)^2 = root^2 + root + 1/4 */
}
