/* SPDX-License-Identifier: MIT */
/*
 * Which integer instructions the target has, and operations on 32 bits that use them. Internal,
 * part of the pipelines' body (pipeline_make.h); the library has more in core/bits.
 */
#ifndef QTRI_BODY_ARITHMETIC_H
#define QTRI_BODY_ARITHMETIC_H

#include <stdint.h>

/* 1 with -Os: core/bits then has one copy of each function of 64 bits, not inlined ones. Stands
   before QTRI_LONG_MULTIPLY, which only tests have set here: they inline. */
#ifndef QTRI_SHARE
#if defined(__OPTIMIZE_SIZE__) && !defined(QTRI_LONG_MULTIPLY)
#define QTRI_SHARE 1
#else
#define QTRI_SHARE 0
#endif
#endif

/* 0 where no instruction multiplies to 64 bits, and where none divides: both on Armv6-M. */
#ifndef QTRI_LONG_MULTIPLY
#if (defined(__thumb__) && !defined(__thumb2__)) || defined(__ARM_ARCH_8M_BASE__) ||               \
    (defined(__riscv) && !defined(__riscv_mul)) || defined(__AVR__) || defined(__MSP430__)
#define QTRI_LONG_MULTIPLY 0
#else
#define QTRI_LONG_MULTIPLY 1
#endif
#endif

#ifndef QTRI_DIVIDE
#if (defined(__arm__) && !defined(__ARM_FEATURE_IDIV)) ||                                          \
    (defined(__riscv) && !defined(__riscv_div)) || defined(__AVR__) || defined(__MSP430__)
#define QTRI_DIVIDE 0
#else
#define QTRI_DIVIDE 1
#endif
#endif

/* In a branch for rare arguments: a compiler does not mix it into the frequent path. */
#ifdef __GNUC__
#define QTRI_RARELY() __asm__ volatile("")
#else
#define QTRI_RARELY() ((void)0)
#endif

/* Leading zeros; 32 for 0. */
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

/* The low half-word. GCC 12 makes two shifts of it where Armv6-M has an instruction. */
static inline uint32_t qtri_low16(uint32_t x)
{
#if defined(__GNUC__) && defined(__thumb__) && !defined(__thumb2__) && __ARM_ARCH >= 6
    if (!__builtin_constant_p(x)) {
        uint32_t low;
        __asm__("uxth %0, %1" : "=l"(low) : "l"(x));
        return low;
    }
#endif
    return x & 0xFFFFu;
}

#endif
