/* SPDX-License-Identifier: MIT */
/*
 * Semihosting: requests to the debugger or emulator (Arm's "Semihosting for AArch32 and AArch64").
 */
#ifndef QTRI_BOARD_SEMIHOSTING_H
#define QTRI_BOARD_SEMIHOSTING_H

#include <stdint.h>

#define UNUSED __attribute__((unused))

/* Operation and argument are expected in r0 and r1, where the calling convention puts them. */
__attribute__((naked, noinline)) static void semihosting_call(
    UNUSED uint32_t operation, UNUSED const volatile uint32_t *argument)
{
#ifdef __thumb__ /* Cortex-M */
    __asm__("bkpt 0xAB\n"
            "bx lr");
#else
    __asm__("svc 0x123456\n"
            "bx lr");
#endif
}

/* SYS_EXIT_EXTENDED: QEMU ends with `status`. Does not return. */
static inline void semihosting_exit(int status)
{
    /* The reason: ADP_Stopped_ApplicationExit. */
    const volatile uint32_t block[2] = {0x20026, (uint32_t)status};
    for (;;) {
        semihosting_call(0x20, block);
    }
}

#endif
