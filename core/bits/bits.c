/* SPDX-License-Identifier: MIT */
/*
 * Products, reciprocals and quotients of integers.
 */

#include "bits.h"
#include "seed.h"

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
