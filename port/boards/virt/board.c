/* SPDX-License-Identifier: MIT */
/*
 * RISC-V "virt" board of QEMU: console on a 16550A UART, exit by SiFive's test finisher,
 * instructions by the core's own counter (startup.S).
 */
#include "../board.h"

#define UART0              ((volatile uint8_t *)(uintptr_t)0x10000000u)
#define UART_DATA          0
#define UART_STATE         5
#define UART_STATE_TX_IDLE 0x20u

#define FINISHER      (*(volatile uint32_t *)(uintptr_t)0x100000u)
#define FINISHER_FAIL 0x3333u /* with the status in the upper half */
#define FINISHER_PASS 0x5555u

#define STACK_PAINT 0xA5A5A5A5u

/* From the linker script; only their addresses mean anything. */
extern const uint32_t stack_low[], stack_top[];

void board_init(void)
{
}

void board_write(const char *text)
{
    for (; *text != '\0'; text++) {
        while ((UART0[UART_STATE] & UART_STATE_TX_IDLE) == 0) {
        }
        UART0[UART_DATA] = (uint8_t)*text;
    }
}

/* Exact with -icount; without it QEMU counts time. */
uint32_t board_instructions(uint32_t from_ticks, uint32_t to_ticks)
{
    return to_ticks - from_ticks;
}

size_t board_stack_used(void)
{
    const uint32_t *deepest = stack_low;
    while (deepest < stack_top && *deepest == STACK_PAINT) {
        deepest++;
    }
    return (uintptr_t)stack_top - (uintptr_t)deepest;
}

void board_exit(int status)
{
    FINISHER = status == 0 ? FINISHER_PASS : (uint32_t)status << 16 | FINISHER_FAIL;
    for (;;) {
    }
}
