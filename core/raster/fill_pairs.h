/*
 * Two pixels at a time on cores with the DSP extension (Cortex-M4, M7, M33). Internal.
 *
 * USUB16 compares two depths and SEL takes from either word what passed: a pair of depths and a
 * pair of RGB565 pixels are loaded, chosen and stored without a branch. Pixels that fail are stored
 * as they were.
 */
#ifndef QTRI_RASTER_FILL_PAIRS_H
#define QTRI_RASTER_FILL_PAIRS_H

#include "fill.h"

#if defined(__GNUC__) && defined(__ARM_FEATURE_DSP) && defined(__ARM_FEATURE_SIMD32) &&            \
    !defined(__ARM_BIG_ENDIAN)
#define QTRI_PAIRS 1
#else
#define QTRI_PAIRS 0
#endif

#if QTRI_PAIRS

/* Whether pixel and depth begin words together, or one pixel on. */
static inline bool qtri_pairs_fit(const uint16_t *pixel, const uint16_t *depth)
{
    return (((uintptr_t)pixel ^ (uintptr_t)depth) & 2) == 0;
}

static inline uint32_t qtri_pair_load(const uint16_t *at)
{
    uint32_t pair;
    __builtin_memcpy(&pair, __builtin_assume_aligned(at, 4), sizeof pair);
    return pair;
}

static inline void qtri_pair_store(uint16_t *at, uint32_t pair)
{
    __builtin_memcpy(__builtin_assume_aligned(at, 4), &pair, sizeof pair);
}

/* Draws pixels 0 and 1 of colours `pair` at depths z0 and z1, 16.16; the first is the low half. */
static inline void qtri_pair_draw(uint16_t *pixel, uint16_t *depth, uint32_t z0, uint32_t z1,
                                  uint32_t pair)
{
    uint32_t stored = qtri_pair_load(depth);
    uint32_t shown = qtri_pair_load(pixel);
    uint32_t z;
    uint32_t unused;
    __asm__("pkhtb %[z], %[z1], %[z0], asr #16\n\t"
            "usub16 %[unused], %[z], %[stored]\n\t" /* GE: not nearer */
            "sel %[z], %[stored], %[z]\n\t"
            "sel %[shown], %[shown], %[pair]"
            : [z] "=&r"(z), [unused] "=&r"(unused), [shown] "+&r"(shown)
            : [z0] "r"(z0), [z1] "r"(z1), [stored] "r"(stored), [pair] "r"(pair));
    qtri_pair_store(depth, z);
    qtri_pair_store(pixel, shown);
}

/* RGB565, one colour, depth "less" with write. */
void qtri_fill_flat_pairs(const qtri_job *job, const qtri_span *spans, int32_t row, int32_t count);

#endif
#endif
