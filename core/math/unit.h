/* SPDX-License-Identifier: MIT */
/*
 * Directions at 30 fraction bits: what normalising, rotating and interpolating start from.
 * Internal.
 */
#ifndef QTRI_MATH_UNIT_H
#define QTRI_MATH_UNIT_H

#include "../bits/bits.h"

/*
 * v / |v| with 1..30 fraction bits, for count <= 4 integers of any common scale: each result within
 * half a unit and 2^-29, for the shortest and the longest v. False, and zeros, for v = 0. out may
 * be v.
 */
bool qtri_unit(int32_t *out, const int32_t *v, int32_t count, int32_t fraction_bits);

/* v / 2^k with the smallest k >= 0 for which all count <= 4 of them fit, rounded down. Gives k. */
int32_t qtri_fit32(int32_t *out, const int64_t *v, int32_t count);

/* v / 2^k, rounded down, where the largest |v| has `bits` < 32 bits; k may be negative. Gives k. */
int32_t qtri_align32(int32_t out[3], const int64_t v[3], int32_t bits);

/* Q2.30 to Q16.16 for |x| <= 2^30. */
static inline int32_t qtri_q30_to_q16(int32_t x_q30)
{
    return (x_q30 + 0x2000) >> 14;
}

/* a b in Q2.30 for |a b| < 2. */
static inline int32_t qtri_mul_q30(int32_t a_q30, int32_t b_q30)
{
    return (int32_t)((qtri_mul_s32(a_q30, b_q30) + 0x20000000) >> 30);
}

/* out = a x b, components below 2^31. */
static inline void qtri_cross64(int64_t out[3], const int32_t a[3], const int32_t b[3])
{
    out[0] = qtri_mul_s32(a[1], b[2]) - qtri_mul_s32(a[2], b[1]);
    out[1] = qtri_mul_s32(a[2], b[0]) - qtri_mul_s32(a[0], b[2]);
    out[2] = qtri_mul_s32(a[0], b[1]) - qtri_mul_s32(a[1], b[0]);
}

#endif
