/*
 * Integer helpers the whole core shares: saturation, rounding shifts, leading zeros, roots and
 * reciprocals of plain integers. Internal.
 */
#ifndef QTRI_MATH_BITS_H
#define QTRI_MATH_BITS_H

#include <stdbool.h>
#include <stdint.h>

/* Right shift of a signed value is arithmetic: every compiler we know; checked, not assumed. */
typedef char qtri_arithmetic_shift_required[(-1 >> 1) == -1 ? 1 : -1];

static inline int32_t qtri_saturate32(int64_t x)
{
    if (x > INT32_MAX) {
        return INT32_MAX;
    }
    return x < INT32_MIN ? INT32_MIN : (int32_t)x;
}

/* |x| as unsigned: right for INT64_MIN too. */
static inline uint64_t qtri_magnitude64(int64_t x)
{
    return x < 0 ? 0 - (uint64_t)x : (uint64_t)x;
}

/* The value of the low 64 bits read as two's complement: sums that are meant to wrap. */
static inline int64_t qtri_wrap64(uint64_t x)
{
    return x > (uint64_t)INT64_MAX ? -(int64_t)(UINT64_MAX - x) - 1 : (int64_t)x;
}

/* x / 2^shift, halves up, for |x| < 2^62; shift >= 0. From 63 up the result is 0. */
static inline int64_t qtri_shift_round(int64_t x, int32_t shift)
{
    if (shift <= 0) {
        return x;
    }
    return shift > 62 ? 0 : (x + ((int64_t)1 << (shift - 1))) >> shift;
}

/* Leading zeros; 32 and 64 for 0. */
#if defined(__GNUC__) && (__SIZEOF_INT__ == 4)
static inline int32_t qtri_clz32(uint32_t x)
{
    return x == 0 ? 32 : __builtin_clz(x);
}
#else
static inline int32_t qtri_clz32(uint32_t x)
{
    int32_t n = 32;
    for (int32_t half = 16; half > 0; half >>= 1) {
        if (x >> half != 0) {
            x >>= half;
            n -= half;
        }
    }
    return n - (int32_t)x;
}
#endif

static inline int32_t qtri_clz64(uint64_t x)
{
    uint32_t high = (uint32_t)(x >> 32);
    return high != 0 ? qtri_clz32(high) : 32 + qtri_clz32((uint32_t)x);
}

/* floor(a b / 2^64). */
uint64_t qtri_mul_high64(uint64_t a, uint64_t b);

/* Nearest integer to the square root; exact halves cannot occur. */
uint32_t qtri_sqrt64_floor(uint64_t x, uint64_t *remainder);
uint64_t qtri_sqrt64_round(uint64_t x);

/*
 * floor(2^62 / x) for x in [2^31, 2^32): the reciprocal of a normalised mantissa, in
 * (2^30, 2^31]; a power of two gives an exact one. x below 2^31 is taken as 2^31.
 */
uint32_t qtri_reciprocal_q62(uint32_t x);

#endif
