/* SPDX-License-Identifier: MIT */
/*
 * Macros that inline the pipelines' body and keep the compiler from mixing pixels' work. Internal,
 * part of the body (pipeline_make.h).
 *
 * GCC 12 computes the values of several unrolled pixels ahead, mixes their work, and then runs out
 * of registers. An empty statement that may change a value, for all the compiler knows, keeps the
 * work of a pixel together, and a branch a branch: a third of the loop on a Cortex-M3.
 */
#ifndef QTRI_BODY_BARRIER_H
#define QTRI_BODY_BARRIER_H

#include "arithmetic.h"

/* Options fold where the function is inlined; without the attribute they are read at run time. */
#if defined(__GNUC__) && defined(__OPTIMIZE__)
#define QTRI_BODY static inline __attribute__((always_inline))
#else
#define QTRI_BODY static inline
#endif

#if defined(__GNUC__) && defined(__thumb__) && !defined(__thumb2__)
#ifdef __OPTIMIZE_SIZE__ /* what is on the stack need not be loaded and stored for it */
#define QTRI_BODY_BARRIER(x) __asm__ volatile("" : "+lm"(x))
#else
#define QTRI_BODY_BARRIER(x) __asm__ volatile("" : "+l"(x))
#endif
#elif defined(__GNUC__)
#define QTRI_BODY_BARRIER(x) __asm__ volatile("" : "+r"(x))
#else
#define QTRI_BODY_BARRIER(x) ((void)0)
#endif

/* Where code is to be small, a barrier helps in loops of one pixel, too; else those have none:
   on Armv6-M each moves its value to a low register. */
#ifdef __OPTIMIZE_SIZE__
#define QTRI_BODY_IS_SMALL true
#else
#define QTRI_BODY_IS_SMALL false
#endif

/* Moves a value that is only added or an index to a high register of Armv6-M, as low ones are few.
   clang 14 knows no such operand; with -Os the value would be moved there and back. */
#if defined(__GNUC__) && !defined(__clang__) && defined(__thumb__) && !defined(__thumb2__) &&      \
    !defined(__OPTIMIZE_SIZE__)
#define QTRI_BODY_HIGH(x)         __asm__ volatile("" : "+h"(x))
#define QTRI_BODY_HIGH_BARRIER(x) QTRI_BODY_HIGH(x)
#else
#define QTRI_BODY_HIGH(x)         ((void)0)
#define QTRI_BODY_HIGH_BARRIER(x) QTRI_BODY_BARRIER(x)
#endif

/* x >> the low byte of `by`, 0..31: where there is an instruction that looks at no other bits. */
QTRI_BODY uint32_t qtri_body_shift(uint32_t x, uint32_t by)
{
#if defined(__GNUC__) && defined(__thumb2__)
    __asm__("lsr %0, %1, %2" : "=r"(x) : "r"(x), "r"(by));
    return x;
#elif defined(__GNUC__) && defined(__thumb__)
    __asm__(".syntax unified\n\tlsrs %0, %1" : "+l"(x) : "l"(by) : "cc");
    return x;
#else
    return x >> (by & 31);
#endif
}

/* `count` bits of x from bit `from` on: two shifts on Armv6-M, where GCC 12 would load a mask. */
QTRI_BODY uint32_t qtri_body_bits(uint32_t x, uint32_t from, uint32_t count)
{
    x <<= 32 - from - count;
#if defined(__GNUC__) && defined(__thumb__) && !defined(__thumb2__)
    QTRI_BODY_BARRIER(x);
#endif
    return x >> (32 - count);
}

/* A function that is not inlined. */
#if defined(__GNUC__)
#define QTRI_BODY_ALONE static __attribute__((noinline))
#else
#define QTRI_BODY_ALONE static
#endif

/* A rare step of a pixel: inlined, but a function with the state's options where these vary. */
#ifdef QTRI_PIPELINE_IS_ANY_BY_ASKS
#define QTRI_BODY_PART          QTRI_BODY_ALONE
#define QTRI_PART_OPTIONS(o, w) (&(w)->state->options)
#else
#define QTRI_BODY_PART          QTRI_BODY
#define QTRI_PART_OPTIONS(o, w) (o)
#endif

/* qtri_pixel_at(): inlined, but in the file that reads options of strokes and lines at run time. */
#ifdef QTRI_PIXEL_IS_ALONE
#define QTRI_BODY_PIXEL QTRI_BODY_ALONE
#else
#define QTRI_BODY_PIXEL QTRI_BODY
#endif

/* Before a loop of at most 8 steps: unrolls it. */
#if defined(__GNUC__) && !defined(__clang__)
#define QTRI_BODY_UNROLL _Pragma("GCC unroll 8")
#else
#define QTRI_BODY_UNROLL
#endif

/* All members 0. */
#ifdef __cplusplus
#define QTRI_BODY_ZERO                                                                             \
    {                                                                                              \
    }
#else
#define QTRI_BODY_ZERO                                                                             \
    {                                                                                              \
        0                                                                                          \
    }
#endif

/* Tells the compiler that x holds, so that it makes no branch for the contrary. */
#if defined(__GNUC__)
#define QTRI_BODY_ASSUME(x)                                                                        \
    do {                                                                                           \
        if (!(x)) {                                                                                \
            __builtin_unreachable();                                                               \
        }                                                                                          \
    } while (0)
#else
#define QTRI_BODY_ASSUME(x) ((void)0)
#endif

/* In a branch: keeps the compiler from making conditional instructions of it. */
#define QTRI_BODY_BRANCH() QTRI_RARELY()

#endif
