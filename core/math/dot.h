/*
 * Sums of products of Q16.16 numbers that round once and never overflow. Internal.
 *
 * A sum of four products needs up to 65 bits. The fast way takes what the processor has and asks
 * afterwards whether that was right; where it was not, and where the result saturates, qtri_dot()
 * does the sum again with more bits.
 *
 *     uint32_t flags = 0;
 *     qtri_right x = qtri_right_of(v.x, &flags), y = qtri_right_of(v.y, &flags);
 *     qtri_sum sum = qtri_sum_start();
 *     qtri_sum_add(&sum, a.x, x, &flags);
 *     qtri_sum_add(&sum, a.y, y, &flags);
 *     q16 result = qtri_sum_q16(&sum, &flags);
 *     return qtri_sum_good(flags) ? result : qtri_dot(...);
 */
#ifndef QTRI_MATH_DOT_H
#define QTRI_MATH_DOT_H

#include "bits.h"

/* Sum of a[i] b[i] for count <= 4: rounded once, to nearest, halves up, and saturated. */
int32_t qtri_dot(const int32_t *a, const int32_t *b, int32_t count);

/* a b - c d, likewise. 64 bits suffice: the extremes are 2^62 + 2^62 - 2^31 and its negative. */
static inline int32_t qtri_dot_cross(int32_t a, int32_t b, int32_t c, int32_t d)
{
    int64_t sum = qtri_mul_s32(a, b) - qtri_mul_s32(c, d) + 0x8000;
    return qtri_saturate32_checked(sum >> 16);
}

/* Up to four products may be added. Bits of the flags from 16 up: do it again. */
static inline bool qtri_sum_good(uint32_t flags)
{
    return flags >> 16 == 0;
}

/* -x, for a right factor; wraps where x itself is flagged. */
static inline int32_t qtri_opposite(int32_t x)
{
    return (int32_t)(0 - (uint32_t)x);
}

/* Holds GCC to one sum or product at a time: it would interleave them, and spill. */
#ifdef __GNUC__
#define QTRI_HOLD(x) __asm__ volatile("" : "+r"(x))
#else
#define QTRI_HOLD(x) ((void)(x))
#endif

#if QTRI_LONG_MULTIPLY

/* 64 bits, where no right factor reaches 2^29: |sum| <= 4 2^31 2^29 = 2^62. Wraps where flagged. */
typedef int32_t qtri_right;
typedef uint64_t qtri_sum;

static inline qtri_right qtri_right_of(int32_t x, uint32_t *flags)
{
    *flags |= ((uint32_t)x + 0x20000000u) >> 14;
    return x;
}

static inline qtri_sum qtri_sum_start(void)
{
    return 0x8000;
}

static inline void qtri_sum_add(qtri_sum *sum, int32_t a, qtri_right b, uint32_t *flags)
{
    *flags |= 0u; /* any left factor will do */
    *sum += (uint64_t)((int64_t)a * b);
}

static inline int32_t qtri_sum_q16(const qtri_sum *sum, uint32_t *flags)
{
    *flags |= (uint32_t)(*sum >> 32) + 0x8000u; /* the high word is a sign and 15 bits? */
    QTRI_HOLD(*flags);
    return (int32_t)(uint32_t)(*sum >> 16 & UINT32_MAX);
}

#else

/*
 * Half-words, h 2^15 + l with 0 <= l < 2^15, and 32-bit sums. With left factors below 2^27 and
 * right ones below 2^28, |h h| <= 2^25, |h l| < 2^27, |l h| < 2^28, l l < 2^30, and so
 * |high| <= 2^27, |middle| < 2^29 + 2^30, low + 2^15 < 2^32. Wraps where flagged.
 */
typedef struct qtri_right {
    uint32_t high, low;
} qtri_right;

typedef struct qtri_sum {
    uint32_t high, middle, low; /* units of 2^30, 2^15, 1 */
} qtri_sum;

static inline qtri_right qtri_right_of(int32_t x, uint32_t *flags)
{
    qtri_right right = {(uint32_t)(x >> 15), (uint32_t)x & 0x7FFFu};
    *flags |= ((uint32_t)x + 0x10000000u) >> 13;
    return right;
}

static inline qtri_sum qtri_sum_start(void)
{
    qtri_sum sum = {0, 0, 0x8000u};
    return sum;
}

static inline void qtri_sum_add(qtri_sum *sum, int32_t a, qtri_right b, uint32_t *flags)
{
    uint32_t high = (uint32_t)(a >> 15);
    uint32_t low = (uint32_t)a & 0x7FFFu;
    *flags |= ((uint32_t)a + 0x08000000u) >> 12;
    sum->high += high * b.high;
    sum->middle += high * b.low + low * b.high;
    sum->low += low * b.low;
    QTRI_HOLD(sum->high);
    QTRI_HOLD(sum->middle);
    QTRI_HOLD(sum->low);
}

/* (high 2^30 + middle 2^15 + low) / 2^16: high 2^14 is held to 2^29, the rest is below 2^30. */
static inline int32_t qtri_sum_q16(const qtri_sum *sum, uint32_t *flags)
{
    *flags |= sum->high + 0x8000u;
    int32_t rest = (int32_t)(sum->middle + (sum->low >> 15));
    return (int32_t)((sum->high << 14) + (uint32_t)(rest >> 1));
}

#endif

#endif
