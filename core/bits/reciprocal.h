/* SPDX-License-Identifier: MIT */
/*
 * Reciprocals for where there is one a vertex, a triangle or a few pixels. Internal.
 */
#ifndef QTRI_BITS_RECIPROCAL_H
#define QTRI_BITS_RECIPROCAL_H

#include "bits.h"
#include "multiply.h"
#include "seed.h"

/*
 * The largest r with r x < 2^62, for x in [2^31, 2^32): in [2^30, 2^31). It is the reciprocal
 * rounded down, except for 2^31, whose own would not fit an int32_t.
 */
static inline int32_t qtri_reciprocal_below(uint32_t x)
{
#if QTRI_LONG_DIVIDE
    uint32_t r = (uint32_t)((((uint64_t)1 << 62) - 1) / x);
#elif QTRI_LONG_MULTIPLY && QTRI_DIVIDE
    /*
     * With d = x / 2^32, s = 1 / d within 2^-15: s (2 - d s) is never more than 1 / d, and at most
     * 2^-30 less; products cut off twice make it less than 4 units.
     */
    uint32_t s_q31 = (0x7FFFFFFFu / (x >> 16)) << 16;
    uint32_t two_less_q31 = ~qtri_mul_high32(x, s_q31);
    uint32_t r = qtri_mul_high32(s_q31, two_less_q31);
    uint64_t rest = ((uint64_t)1 << 62) - (uint64_t)x * r;
    while (rest > x) {
        rest -= x;
        r++;
    }
#else
    uint32_t r = qtri_reciprocal_q62(x);
    r -= r >> 31;
#endif
    int32_t reciprocal = (int32_t)r;
    QTRI_HOLD(reciprocal); /* signed, or GCC 12 forgets what smull is for */
    return reciprocal;
}

/*
 * 2^62 / x within 4 units, for x in [2^31, 2^32): the same number on all cores, as nothing corrects
 * it. The seed is off by 5/4 of 2^-15 of itself at most, see seed.h, and a Newton step squares
 * that: 2^-29.4 of a reciprocal of up to 2^31 is less than 3 units; cut-off bits are one.
 */
static inline uint32_t qtri_reciprocal_near(uint32_t x)
{
    uint32_t r_q15 = qtri_reciprocal_seed_newton(x >> 16);
    uint32_t unit_q31 = qtri_mul_high16(x, r_q15);
    int32_t error_q31 = (int32_t)(0x80000000u - unit_q31); /* see qtri_reciprocal_q62 */
    return (r_q15 << 15) + (uint32_t)(((error_q31 >> 1) * (int32_t)r_q15) >> 15);
}

/* floor(2^31 / x) for x in [2^15, 2^16]. */
static inline uint32_t qtri_reciprocal_q31(uint32_t x)
{
    uint32_t y = qtri_reciprocal_seed(x);
#if !QTRI_DIVIDE
    int32_t rest = (int32_t)(0x80000000u - x * y); /* of every x the seed leaves 0..5/4 x */
    while (rest >= (int32_t)x) {
        rest -= (int32_t)x;
        y++;
    }
#endif
    return y;
}

#endif
