/* SPDX-License-Identifier: MIT */
/*
 * What firmware for a core sets up before it draws.
 */
#ifndef BENCH_CORE_H
#define BENCH_CORE_H

#include <stdint.h>

/*
 * Unaligned loads are allowed, which the start-up code makes faults (Armv7-M B3.2.8), and the FPU
 * is switched on (B3.2.20), since compilers keep integers in its registers too.
 */
static inline void bench_set_up_core(void)
{
#if defined __ARM_FEATURE_UNALIGNED
    *(volatile uint32_t *)0xE000ED14u &= ~(1u << 3);
#endif
#if defined __ARM_FP && defined __ARM_ARCH_7EM__
    *(volatile uint32_t *)0xE000ED88u |= 0xFu << 20;
    __asm__ volatile("dsb\nisb");
#endif
}

#endif
