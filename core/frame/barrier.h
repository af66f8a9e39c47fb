/* SPDX-License-Identifier: MIT */
/*
 * Against what GCC 12 makes of unrolled loops. Internal.
 *
 * It computes several pixels' values ahead and mixes their work, and then runs out of registers.
 * An empty statement that may change a value, for all the compiler knows, keeps each pixel's work
 * together, and a branch a branch: a third of the loop on a Cortex-M3.
 */
#ifndef QTRI_FRAME_BARRIER_H
#define QTRI_FRAME_BARRIER_H

#include <stdint.h>

#include "../bits/bits.h"

#if defined(__GNUC__) && defined(__thumb__) && !defined(__thumb2__)
#define QTRI_OPAQUE(x) __asm__ volatile("" : "+l"(x));
/* Where code is to be small it would move x there and back; clang 14 ends on such an operand. */
#if defined(__OPTIMIZE_SIZE__) || defined(__clang__)
#define QTRI_ASIDE(x)
#else
#define QTRI_ASIDE(x) __asm__ volatile("" : "+h"(x));
#endif
#define QTRI_BRANCH __asm__ volatile("");
#elif defined(__GNUC__)
#define QTRI_OPAQUE(x) __asm__ volatile("" : "+r"(x));
#define QTRI_ASIDE(x)
#define QTRI_BRANCH __asm__ volatile("");
#else
#define QTRI_OPAQUE(x)
#define QTRI_ASIDE(x)
#define QTRI_BRANCH
#endif

/* What was just computed: a product and its sum are one instruction, which GCC takes apart. */
#if defined(__GNUC__) && defined(__thumb2__) && !defined(__OPTIMIZE_SIZE__)
#define QTRI_TOGETHER(x) QTRI_OPAQUE(x)
#else
#define QTRI_TOGETHER(x)
#endif

/* Bytes in the other order: an instruction of Arm's, which the barrier keeps whole. */
QTRI_INLINE uint32_t qtri_reversed(uint32_t x)
{
    x = x << 24 | (x & 0xFF00) << 8 | (x >> 8 & 0xFF00) | x >> 24;
    QTRI_OPAQUE(x)
    return x;
}

/*
 * Makes of each x of `count` words the `result`, in place, for descriptions of formats: `words` is
 * a variable that moves on. Up to three words more are changed, so that groups of four need no
 * remainder.
 */
/* clang-format off */
#define QTRI_ONE_WORD(words, i, x, result)                                                         \
    {                                                                                              \
        const uint32_t x = (words)[i];                                                             \
        (words)[i] = (result);                                                                     \
        QTRI_OPAQUE(words)                                                                         \
    }
#ifdef __OPTIMIZE_SIZE__
#define QTRI_EACH_WORD(words, count, x, result)                                                    \
    for (const uint32_t *end = (words) + (count); (words) < end; (words)++) {                      \
        QTRI_ONE_WORD(words, 0, x, result)                                                         \
    }
#else
#define QTRI_EACH_WORD(words, count, x, result)                                                    \
    for (const uint32_t *end = (words) + (count); (words) < end; (words) += 4) {                   \
        QTRI_ONE_WORD(words, 0, x, result)                                                         \
        QTRI_ONE_WORD(words, 1, x, result)                                                         \
        QTRI_ONE_WORD(words, 2, x, result)                                                         \
        QTRI_ONE_WORD(words, 3, x, result)                                                         \
    }
#endif
/* clang-format on */

#endif
