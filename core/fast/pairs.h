/* SPDX-License-Identifier: MIT */
/*
 * Two pixels at a time, on cores with Thumb-2. Internal.
 *
 * One load brings two stored depths, the first in the low half. With QTRI_SELECT 0 each half is
 * compared where it is, and its pixel drawn if it passes. With QTRI_SELECT 1, on cores with the DSP
 * extension (Cortex-M4, M7, M33), USUB16 compares both and SEL takes what passes from either word,
 * of depths and of colours, without a branch; pixels that fail are stored as they were.
 *
 * All words are aligned: what others cost, and whether they fault, depends on the kind of memory.
 * So depths begin a word, and with QTRI_SELECT pixels too; where a row begins in the middle of one,
 * its first pixel is drawn alone.
 *
 * With other compilers and on other cores all of this is plain C, for the tests.
 */
#ifndef QTRI_FAST_PAIRS_H
#define QTRI_FAST_PAIRS_H

#include "../raster/job.h"
#include "../raster/loop.h"
#include "fused.h"

#if defined(__GNUC__) && defined(__thumb2__) && defined(__ARM_FEATURE_DSP) &&                      \
    defined(__ARM_FEATURE_SIMD32) && !defined(__ARM_BIG_ENDIAN)
#define QTRI_DSP 1
#else
#define QTRI_DSP 0
#endif

#ifndef QTRI_SELECT
#define QTRI_SELECT QTRI_DSP
#endif

/* Whether these functions are the fastest; they are long, since they are unrolled. */
#if defined(__GNUC__) && defined(__thumb2__) && !defined(__ARM_BIG_ENDIAN) &&                      \
    !defined(__OPTIMIZE_SIZE__)
#define QTRI_PAIRS 1
#else
#define QTRI_PAIRS 0
#endif

/* Two of 16 bits, the first in the low half. */
static inline uint32_t qtri_pair_load(const uint16_t *at)
{
#if QTRI_PAIRS
    uint32_t pair;
    __builtin_memcpy(&pair, __builtin_assume_aligned(at, 4), sizeof pair);
    return pair;
#else
    return at[0] | (uint32_t)at[1] << 16;
#endif
}

/* The low halves of two colours. */
static inline uint32_t qtri_pair_low(uint32_t first, uint32_t second)
{
#if QTRI_DSP
    uint32_t pair;
    __asm__("pkhbt %0, %1, %2, lsl #16" : "=r"(pair) : "r"(first), "r"(second));
    return pair;
#else
    return (first & 0xFFFF) | second << 16;
#endif
}

/* The high halves of two depths. */
static inline uint32_t qtri_pair_high(uint32_t first, uint32_t second)
{
#if QTRI_DSP
    uint32_t pair;
    __asm__("pkhtb %0, %2, %1, asr #16" : "=r"(pair) : "r"(first), "r"(second));
    return pair;
#else
    return first >> 16 | (second & 0xFFFF0000u);
#endif
}

/* Draws two pixels where `z` is less than the depths that are stored, or equal, and moves on. */
QTRI_IN_PLACE void qtri_pair_select(uint16_t **pixel, uint16_t **depth, uint32_t z, uint32_t colors,
                                    bool equal)
{
#if QTRI_DSP
    uint32_t stored, shown;
    if (equal) {
        __asm__ volatile("ldr %[stored], [%[depth]]\n\t"
                         "usub16 %[shown], %[stored], %[z]\n\t" /* GE: not farther */
                         "ldr %[shown], [%[pixel]]\n\t"
                         "sel %[stored], %[z], %[stored]\n\t"
                         "sel %[shown], %[colors], %[shown]\n\t"
                         "str %[stored], [%[depth]], #4\n\t"
                         "str %[shown], [%[pixel]], #4"
                         : [stored] "=&r"(stored), [shown] "=&r"(shown), [depth] "+&r"(*depth),
                           [pixel] "+&r"(*pixel)
                         : [z] "r"(z), [colors] "r"(colors)
                         : "memory");
    } else {
        __asm__ volatile("ldr %[stored], [%[depth]]\n\t"
                         "usub16 %[shown], %[z], %[stored]\n\t" /* GE: not nearer */
                         "ldr %[shown], [%[pixel]]\n\t"
                         "sel %[stored], %[stored], %[z]\n\t"
                         "sel %[shown], %[shown], %[colors]\n\t"
                         "str %[stored], [%[depth]], #4\n\t"
                         "str %[shown], [%[pixel]], #4"
                         : [stored] "=&r"(stored), [shown] "=&r"(shown), [depth] "+&r"(*depth),
                           [pixel] "+&r"(*pixel)
                         : [z] "r"(z), [colors] "r"(colors)
                         : "memory");
    }
#else
    for (int i = 0; i < 2; i++) {
        uint16_t z_i = (uint16_t)(z >> 16 * i);
        if (qtri_passes(z_i, **depth, equal)) {
            **depth = z_i;
            **pixel = (uint16_t)(colors >> 16 * i);
        }
        ++*depth;
        ++*pixel;
    }
#endif
}

/* Whether depths and pixels are at words together: pairs go from here on or the next pixel. */
static inline bool qtri_pairs_fit(const uint16_t *pixel, const uint16_t *depth)
{
    return !QTRI_SELECT || (((uintptr_t)pixel ^ (uintptr_t)depth) & 2) == 0;
}

static inline bool qtri_pair_begins(const uint16_t *depth)
{
    return ((uintptr_t)depth & 2) == 0;
}

/* RGB565, depth "less" with write: one colour, linear colours, copied texels. */
void qtri_flat_pairs(const qtri_job *job, const qtri_span *spans, int32_t row, int32_t count);
void qtri_smooth_pairs(const qtri_job *job, const qtri_span *spans, int32_t row, int32_t count);
void qtri_copy_pairs(const qtri_job *job, const qtri_run *run);

/* The same of depth "less or equal". */
void qtri_flat_pairs_lequal(const qtri_job *job, const qtri_span *spans, int32_t row,
                            int32_t count);
void qtri_smooth_pairs_lequal(const qtri_job *job, const qtri_span *spans, int32_t row,
                              int32_t count);
void qtri_copy_pairs_lequal(const qtri_job *job, const qtri_run *run);

#endif
