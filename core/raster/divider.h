/* SPDX-License-Identifier: MIT */
/*
 * Many quotients by one number; for two or three, a division costs less. Internal.
 *
 * Where the core has no instruction that divides, by the reciprocal r = floor(2^32 / divisor),
 * 2^32 - 1 for 1: n / divisor - n r / 2^32 <= n / 2^32 <= 1/2 for n <= 2^31, so that the product's
 * floor is the quotient or one less. The values are those of a division.
 */
#ifndef QTRI_RASTER_DIVIDER_H
#define QTRI_RASTER_DIVIDER_H

#include "../bits/bits.h"

typedef struct qtri_divider {
    uint32_t divisor;
    uint32_t reciprocal_q32; /* where it is needed */
} qtri_divider;

/* 0 < divisor < 2^31. */
static inline void qtri_divider_init(qtri_divider *by, uint32_t divisor)
{
    by->divisor = divisor;
    by->reciprocal_q32 = 0;
    if (!QTRI_DIVIDE) {
        int32_t zeros = qtri_clz32(divisor);
        by->reciprocal_q32 =
            zeros > 30 ? UINT32_MAX : qtri_reciprocal_q62(divisor << zeros) >> (30 - zeros);
    }
}

/*
 * For divisors below 2^16: the seed and a step that squares its error are not above 2^32 / divisor
 * and less than 1.01 below it, so that this, too, is the quotient or one less (all divisors tried).
 */
static inline void qtri_divider_init_short(qtri_divider *by, uint32_t divisor)
{
    by->divisor = divisor;
    by->reciprocal_q32 = 0;
    if (!QTRI_DIVIDE) {
        const int32_t zeros = qtri_clz32(divisor); /* >= 16 */
        const uint32_t x = divisor << (zeros - 16);
        const uint32_t r_q15 = qtri_reciprocal_seed(x);
        const int32_t error_q31 = (int32_t)(0x80000000u - x * r_q15); /* |error| < 2^17 */
        const uint32_t r_q30 =
            (r_q15 << 15) + (uint32_t)(((error_q31 >> 1) * (int32_t)r_q15) >> 15);
        by->reciprocal_q32 = zeros > 30 ? UINT32_MAX : r_q30 >> (30 - zeros);
    }
}

/* Towards zero, as a division in C. */
static inline int32_t qtri_divide(int32_t n, const qtri_divider *by)
{
    if (QTRI_DIVIDE) {
        return n / (int32_t)by->divisor;
    }
    uint32_t magnitude = qtri_magnitude32(n);
    uint32_t quotient = qtri_mul_high32(magnitude, by->reciprocal_q32);
    quotient += magnitude - quotient * by->divisor >= by->divisor;
    return n < 0 ? -(int32_t)quotient : (int32_t)quotient;
}

#endif
