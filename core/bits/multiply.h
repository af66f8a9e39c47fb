/* SPDX-License-Identifier: MIT */
/*
 * High words of products. Internal.
 *
 * A Cortex-M0+ multiplies 32 by 32 bits to 32: there the product is put together from half-words,
 * in 6 to 15 instructions where the compiler's 64-bit product takes 35. Both forms give the
 * same bits.
 */
#ifndef QTRI_BITS_MULTIPLY_H
#define QTRI_BITS_MULTIPLY_H

#include "bits.h"

/* floor(a b / 2^32) for a, b <= 2^31. */
static inline uint32_t qtri_mul_high31(uint32_t a, uint32_t b)
{
#if QTRI_LONG_MULTIPLY
    return (uint32_t)(((uint64_t)a * b) >> 32);
#else
    uint32_t a_high = a >> 16; /* <= 2^15, and a_low = 0 where it is equal; b likewise */
    uint32_t b_high = b >> 16;
    uint32_t a_low = a & 0xFFFFu;
    uint32_t b_low = b & 0xFFFFu;
    uint32_t middle = a_high * b_low + a_low * b_high + ((a_low * b_low) >> 16); /* < 2^32 */
    return a_high * b_high + (middle >> 16);
#endif
}

/* floor(a b / 2^32) for |a| <= 2^30, 0 <= b < 2^30. */
static inline int32_t qtri_mul_high_s30(int32_t a, int32_t b)
{
#if QTRI_LONG_MULTIPLY
    return (int32_t)(qtri_mul_s32(a, b) >> 32);
#else
    int32_t a_high = a >> 16; /* |.| <= 2^14, and a_low = 0 where a is 2^30 */
    int32_t b_high = b >> 16; /* < 2^14 */
    int32_t a_low = (int32_t)qtri_low16((uint32_t)a);
    int32_t b_low = (int32_t)qtri_low16((uint32_t)b);
    int32_t carry = (int32_t)(((uint32_t)a_low * (uint32_t)b_low) >> 16);
    int32_t middle = a_high * b_low + a_low * b_high + carry; /* < 2^30 + 2^30 - 2^16 */
    return a_high * b_high + (middle >> 16);
#endif
}

/* floor(a b / 2^16) for b < 2^16. */
static inline uint32_t qtri_mul_high16(uint32_t a, uint32_t b)
{
#if QTRI_LONG_MULTIPLY
    return (uint32_t)(((uint64_t)a * (b << 16)) >> 32); /* the high word: no shift of two words */
#else
    return (a >> 16) * b + (((a & 0xFFFFu) * b) >> 16);
#endif
}

/* a b / 2^16 to nearest for b < 2^16. */
static inline uint32_t qtri_mul_round16(uint32_t a, uint32_t b)
{
#if QTRI_LONG_MULTIPLY
    return (uint32_t)(((uint64_t)a * (b << 16) + 0x80000000u) >> 32);
#else
    return (a >> 16) * b + (((a & 0xFFFFu) * b + 0x8000u) >> 16);
#endif
}

/* floor(a b / 2^12) modulo 2^32 for b <= 2^16. */
static inline uint32_t qtri_mul_wrap12(uint32_t a, uint32_t b)
{
#if QTRI_LONG_MULTIPLY
    return (uint32_t)(((uint64_t)a * b) >> 12);
#else
    return (((a >> 16) * b) << 4) + (((a & 0xFFFFu) * b) >> 12);
#endif
}

/* floor(a b / 2^16) for |b| < 2^15. */
static inline int32_t qtri_mul_s16(int32_t a, int32_t b)
{
#if QTRI_LONG_MULTIPLY
    return (int32_t)(qtri_mul_s32(a, b * 65536) >> 32); /* as qtri_mul_high16() */
#else
    return (a >> 16) * b + (((int32_t)qtri_low16((uint32_t)a) * b) >> 16);
#endif
}

/* floor(a b / 2^32) for |a| < 2^31, b <= 2^31. */
static inline int32_t qtri_mul_high_s31(int32_t a, uint32_t b)
{
#if QTRI_LONG_MULTIPLY
    return (int32_t)(((int64_t)a * b) >> 32);
#else
    int32_t a_high = a >> 16; /* |.| <= 2^15 */
    uint32_t a_low = qtri_low16((uint32_t)a);
    uint32_t b_high = b >> 16; /* <= 2^15 */
    uint32_t b_low = qtri_low16(b);
    int32_t cross = a_high * (int32_t)b_low + (int32_t)((a_low * b_low) >> 16); /* |.| < 2^31 */
    uint32_t cross_low = a_low * b_high + qtri_low16((uint32_t)cross);          /* < 2^32 */
    return a_high * (int32_t)b_high + (cross >> 16) + (int32_t)(cross_low >> 16);
#endif
}

#endif
