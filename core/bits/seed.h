/* SPDX-License-Identifier: MIT */
/*
 * First estimates of quotients and roots, of products that fit 32 bits. Internal.
 *
 * They are as good as 16 bits allow; whoever uses them finds the exact remainder and corrects. The
 * tests try every argument, of both variants, against the bounds given here.
 */
#ifndef QTRI_BITS_SEED_H
#define QTRI_BITS_SEED_H

#include "bits.h"

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

#endif
