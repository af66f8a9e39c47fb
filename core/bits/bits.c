/* SPDX-License-Identifier: MIT */
/*
 * Products, reciprocals, quotients and roots of integers.
 */

#include "bits.h"

uint64_t qtri_mul_high64(uint64_t a, uint64_t b)
{
    uint32_t a_low = (uint32_t)(a & UINT32_MAX);
    uint32_t a_high = (uint32_t)(a >> 32);
    uint32_t b_low = (uint32_t)(b & UINT32_MAX);
    uint32_t b_high = (uint32_t)(b >> 32);
    /* Both sums are at most (2^32-1)^2 + 2^32-1 < 2^64. */
    uint64_t cross = qtri_mul_u32(a_high, b_low) + qtri_mul_high32(a_low, b_low);
    uint64_t cross_low = qtri_mul_u32(a_low, b_high) + (cross & UINT32_MAX);
    return qtri_mul_u32(a_high, b_high) + (cross >> 32) + (cross_low >> 32);
}

/*
 * Newton's step from a seed of 16 bits: r + r (1 - d r) with d = x / 2^32. Its factor 1 - d r is
 * within 2^-15, so that the step leaves at most 2 units too little, and cut-off bits as many; the
 * remainder tells the rest.
 */
uint32_t qtri_reciprocal_q62(uint32_t x)
{
    if (x <= 0x80000000u) {
        return 0x80000000u;
    }
    uint32_t r_q15 = qtri_reciprocal_seed(x >> 16);
    uint32_t unit_q31 = (x >> 16) * r_q15 + ((qtri_low16(x) * r_q15) >> 16);
    int32_t error_q31 = (int32_t)(0x80000000u - unit_q31); /* >= -2^16, <= 2 (x >> 16) */
    uint32_t r_q30 = (r_q15 << 15) + (uint32_t)(((error_q31 >> 1) * (int32_t)r_q15) >> 15);
    int64_t remainder = qtri_wrap64(((uint64_t)1 << 62) - qtri_mul_u32(x, r_q30));
    while (remainder >= (int64_t)x) {
        r_q30++;
        remainder -= x;
    }
    while (remainder < 0) {
        r_q30--;
        remainder += x;
    }
    return r_q30;
}

uint64_t qtri_divide64(uint64_t n, uint64_t divisor, int32_t more, bool *half)
{
    int32_t up = qtri_clz64(divisor) - qtri_clz64(n); /* as many digits: then n < 2 divisor 2^up */
    up = up > 0 ? up : 0;
    divisor <<= up;
    uint64_t quotient = 0;
    for (int32_t digits = up + 1 + more; digits > 0; digits--) {
        quotient <<= 1;
        if (n >= divisor) {
            n -= divisor;
            quotient |= 1;
        }
        n <<= 1; /* < 2 divisor again */
    }
    *half = n >= divisor;
    return quotient;
}

uint32_t qtri_rsqrt_seed(uint32_t t)
{
    return qtri_rsqrt_seed_in_place(t);
}

/* ---- Roots ---- */

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
    uint32_t low = half / s; /* s >= 2^15 */
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
