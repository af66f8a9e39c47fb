/* SPDX-License-Identifier: MIT */
/*
 * Reciprocals for where there is one a vertex, a triangle or a few pixels. Internal.
 */
#ifndef QTRI_BITS_RECIPROCAL_H
#define QTRI_BITS_RECIPROCAL_H

#include "bits.h"

/*
 * First estimates of quotients and roots, of products that fit 32 bits. They are as good as 16 bits
 * allow; whoever uses them finds the exact remainder and corrects. The tests try every argument, of
 * both variants, against the bounds given here.
 */

/*
 * 2^31 / x for x in [2^15, 2^16]: in [2^15 - 1, 2^16], with 0 <= 2^31 - x seed < 5/4 x.
 * Without a division: with d = x / 2^16, the line 48/17 - 32/17 d is within 1/17 of 1/d. Newton's
 * step r (2 - d r) squares that error, which is then never positive; with 2 + 2/17^2 in place of 2
 * it is centred: 2^-9. The second step r + r (1 - d r) leaves 2^-18 and the rounding to Q15.
 */
static inline uint32_t qtri_reciprocal_seed_newton(uint32_t x)
{
    uint32_t r_q14 = 46260u - ((x * 30840u) >> 16);                   /* < 2^15 (1 + 1/17) */
    uint32_t r_q15 = (r_q14 * (131192u - ((x * r_q14) >> 14))) >> 15; /* Q14 Q16, < 2^31.1 */
    int32_t error_q31 = (int32_t)(0x80000000u - x * r_q15);           /* |error| < 2^22 */
    return r_q15 + (uint32_t)(((int32_t)r_q15 * (error_q31 >> 7)) >> 24);
}

/* Within the same bounds, but not the same on all cores. */
static inline uint32_t qtri_reciprocal_seed(uint32_t x)
{
#if QTRI_DIVIDE
    return 0x80000000u / x; // NOLINT(clang-analyzer-core.DivideZero): x is 2^15 or more
#else
    return qtri_reciprocal_seed_newton(x);
#endif
}

/* 1 / sqrt(v) in Q15 for v = t / 2^16, t in [2^14, 2^16): within 2^-13 of itself, <= 2^16 + 4. */
uint32_t qtri_rsqrt_seed(uint32_t t);

/*
 * The same where it is wanted in place.
 *
 * A cubic with the least relative error on [1/4, 1], 2^-7.1, and Newton's step y (3 - v y^2) / 2
 * with a 3 that centres the error as qtri_reciprocal_seed does.
 */
QTRI_IN_PLACE uint32_t qtri_rsqrt_seed_in_place(uint32_t t)
{
    uint32_t p_q13 = 51036u - ((19976u * t) >> 16);
    p_q13 = 48422u - ((p_q13 * t) >> 16);
    uint32_t y_q14 = 50993u - ((p_q13 * t) >> 15);           /* < 2^15 (1 + 2^-7) */
    uint32_t unit_q30 = ((y_q14 * y_q14) >> 14) * t;         /* v y^2, close to 1 */
    return (y_q14 * ((3221310472u - unit_q30) >> 15)) >> 15; /* Q14 Q16, < 2^31.1 */
}

/* ---- Reciprocals ---- */

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
