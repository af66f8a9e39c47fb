/* SPDX-License-Identifier: MIT */
/*
 * Sums of products of Q16.16 numbers that round once and never overflow. Internal.
 *
 * A sum of four products needs up to 65 bits. The fast way takes what the processor has; where its
 * flags say that this was not enough, qtri_dot() does the sum again with more bits.
 *
 *     uint32_t flags = 0;
 *     qtri_right x = qtri_right_of(v.x, &flags), y = qtri_right_beside(v.y, &flags);
 *     qtri_sum sum = qtri_sum_start();
 *     qtri_sum_product(&sum, a.x, x, &flags);
 *     qtri_sum_product(&sum, a.y, y, &flags);
 *     q16 result = qtri_sum_q16(&sum, &flags);
 *     return qtri_sum_good(flags) ? result : qtri_dot(...);
 */
#ifndef QTRI_MATH_DOT_H
#define QTRI_MATH_DOT_H

#include "../bits/bits.h"
#include "../bits/wide.h"

/* Sum of a[i] b[i] for count <= 4: rounded once, to nearest, halves up, and saturated. */
int32_t qtri_dot(const int32_t *a, const int32_t *b, int32_t count);

/* n rows of n elements times a column. */
void qtri_dot_rows(int32_t *out, const int32_t *rows, const int32_t *column, int32_t n);

/* a b - c d, likewise. */
int32_t qtri_dot_cross(int32_t a, int32_t b, int32_t c, int32_t d);

/* Up to four products may be added. Bits of the flags from 12 up: do it again. */
static inline bool qtri_sum_good(uint32_t flags)
{
    return flags >> 12 == 0;
}

/* Its bits from n up are 0 where -2^n <= x < 2^n. */
static inline uint32_t qtri_sum_size(int32_t x)
{
    return (uint32_t)x ^ (0 - ((uint32_t)x >> 31));
}

#if QTRI_LONG_MULTIPLY

/*
 * 64 bits, which wrap. Four products are 2^64 at most: a sum that wrapped to less than 2^47 would
 * be of four that each are within 2^47 of 2^62, and of no factor below 2^30. So it is enough to
 * know that one factor is, and that the sum fits.
 */
typedef int32_t qtri_right;
typedef uint64_t qtri_sum;

static inline qtri_right qtri_right_of(int32_t x, uint32_t *flags)
{
    *flags |= qtri_sum_size(x) >> 18;
    return x;
}

/* A right factor added beside a checked one. */
static inline qtri_right qtri_right_beside(int32_t x, uint32_t *flags)
{
    *flags |= 0u; /* any will do */
    return x;
}

/* -x, where x is a checked one. */
static inline qtri_right qtri_right_opposite(int32_t x)
{
    return (int32_t)(0 - (uint32_t)x);
}

static inline qtri_sum qtri_sum_start(void)
{
    return 0;
}

static inline void qtri_sum_product(qtri_sum *sum, int32_t a, qtri_right b, uint32_t *flags)
{
    *flags |= 0u; /* any left factor will do */
    *sum += (uint64_t)((int64_t)a * b);
}

/* The low 32 bits of sum / 2^16 to nearest. A shift leaves the last bit shifted out in the carry.
 */
static inline int32_t qtri_sum_low(uint32_t high, uint32_t low)
{
#if defined(__GNUC__) && defined(__thumb2__)
    uint32_t result;
    __asm__("lsrs %0, %1, #16\n\tadc %0, %0, %2, lsl #16"
            : "=&r"(result)
            : "r"(low), "r"(high)
            : "cc");
    return (int32_t)result;
#else
    return (int32_t)((high << 16) + (((low >> 15) + 1) >> 1));
#endif
}

/* Flags a sum that does not fit, and one that has just carried. */
static inline int32_t qtri_sum_q16(const qtri_sum *sum, uint32_t *flags)
{
    uint32_t high = (uint32_t)(*sum >> 32);
    int32_t result = qtri_sum_low(high, (uint32_t)(*sum & UINT32_MAX));
    if (high != (uint32_t)(result >> 16)) {
        QTRI_RARELY();
        *flags = UINT32_MAX;
    }
    return result;
}

#else

/*
 * Half-words, h 2^15 + l with 0 <= l < 2^15, and 32-bit sums: of h h, of l l, and of (h + l) (h +
 * l), which less the others is h l + l h (Karatsuba) and wraps on the way. With left factors below
 * 2^27 and right ones up to 2^28, |h h| <= 2^25, |h l| < 2^27, |l h| < 2^28, l l < 2^30, and so
 * |high| <= 2^27, |middle| < 2^29 + 2^30, low < 2^32. Wraps where flagged.
 */
typedef struct qtri_right {
    uint32_t high, low, both;
} qtri_right;

typedef struct qtri_sum {
    uint32_t high, low, both;
} qtri_sum;

static inline qtri_right qtri_right_of(int32_t x, uint32_t *flags)
{
    uint32_t high = (uint32_t)(x >> 15);
    uint32_t low = (uint32_t)x & 0x7FFFu;
    qtri_right right = {high, low, high + low};
    *flags |= qtri_sum_size(x >> 15) >> 1;
    return right;
}

static inline qtri_right qtri_right_beside(int32_t x, uint32_t *flags)
{
    return qtri_right_of(x, flags);
}

static inline qtri_right qtri_right_opposite(int32_t x)
{
    uint32_t unchecked = 0;
    return qtri_right_of((int32_t)(0 - (uint32_t)x), &unchecked);
}

static inline qtri_sum qtri_sum_start(void)
{
    qtri_sum sum = {0, 0, 0};
    return sum;
}

static inline void qtri_sum_product(qtri_sum *sum, int32_t a, qtri_right b, uint32_t *flags)
{
    uint32_t high = (uint32_t)(a >> 15);
    uint32_t low = (uint32_t)a & 0x7FFFu;
    *flags |= qtri_sum_size((int32_t)high);
    QTRI_HOLD(*flags);
    sum->high += high * b.high;
    QTRI_HOLD(sum->high);
    sum->low += low * b.low;
    QTRI_HOLD(sum->low);
    sum->both += (high + low) * b.both;
    QTRI_HOLD(sum->both);
}

/* (high 2^30 + middle 2^15 + low) / 2^16, saturated. The half that rounds is 2^15. */
static inline int32_t qtri_sum_q16(const qtri_sum *sum, uint32_t *flags)
{
    int32_t rest = (int32_t)(sum->both - sum->high - sum->low + (sum->low >> 15) + 1); /* < 2^31 */
    int32_t size = (int32_t)(sum->high + (uint32_t)(rest >> 15)); /* the sum / 2^30, rounded down */
    if (qtri_sum_size(size) >> 17 != 0) {
        QTRI_RARELY();
        QTRI_MATH_CHECK(!qtri_sum_good(*flags));
        return qtri_extreme32(size);
    }
    *flags |= 0u;
    return (int32_t)((sum->high << 14) + (uint32_t)(rest >> 1));
}

#endif

/* ---- From wide scalars to Q16.16 ---- */

/* Nearest, halves up, saturated. */
int32_t qtri_wide_to_q16(qtri_wide a);

/* m 2^-16 - a b, rounded like that. */
int32_t qtri_wide_less(int64_t m, const qtri_wide *a, const qtri_wide *b);

/* The sum of a[i] b[i], of the real numbers; as exact as it needs to be for all count <= 4. */
void qtri_wide_dot(qtri_wide *sum, const int32_t *a, const int32_t *b, int32_t count);

/* x = numerator / x. */
void qtri_wide_invert(qtri_wide *x, int32_t numerator);

#endif
