/* SPDX-License-Identifier: MIT */
/*
 * Arm MPS2 (QEMU mps2-an385, -an386, -an500): console on UART 0, instructions by SysTick.
 */
#include "../board.h"

#include "../common/semihosting.h"

#define CLOCK_HZ 25000000u

/* Cortex-M System Design Kit, APB UART (Arm DDI 0479, 4.3). */
#define UART0 ((volatile uint32_t *)0x40004000u)
enum { UART_DATA, UART_STATE, UART_CONTROL, UART_INTERRUPT, UART_BAUD_DIVIDER };
#define UART_STATE_TX_FULL 1u
#define UART_CONTROL_TX    1u
#define BAUD               115200u

/* Armv7-M B3.3, Armv6-M B3.3. The value counts down from the reload value. */
#define SYSTICK ((volatile uint32_t *)0xE000E010u)
enum { SYSTICK_CONTROL, SYSTICK_RELOAD, SYSTICK_VALUE };
#define SYSTICK_ENABLE     1u
#define SYSTICK_CORE_CLOCK 4u
#define SYSTICK_MAX        0xFFFFFFu /* 24 bits */

/* With -icount shift=0 an instruction takes 1 ns, a tick of the 25 MHz clock 40 ns. */
#define INSTRUCTIONS_PER_TICK (1000000000u / CLOCK_HZ)

void board_init(void)
{
    UART0[UART_BAUD_DIVIDER] = CLOCK_HZ / BAUD;
    UART0[UART_CONTROL] = UART_CONTROL_TX;
    SYSTICK[SYSTICK_RELOAD] = SYSTICK_MAX;
    SYSTICK[SYSTICK_VALUE] = 0; /* any write clears it */
    SYSTICK[SYSTICK_CONTROL] = SYSTICK_ENABLE | SYSTICK_CORE_CLOCK;
}

void board_write(const char *text)
{
    for (; *text != '\0'; text++) {
        while ((UART0[UART_STATE] & UART_STATE_TX_FULL) != 0) {
        }
        UART0[UART_DATA] = (uint8_t)*text;
    }
}

uint32_t board_ticks(void)
{
    return SYSTICK[SYSTICK_VALUE];
}

/* Good for up to 2^24 ticks: 671 million instructions. */
uint32_t board_instructions(uint32_t from_ticks, uint32_t to_ticks)
{
    return ((from_ticks - to_ticks) & SYSTICK_MAX) * INSTRUCTIONS_PER_TICK;
}

void board_exit(int status)
{
    semihosting_exit(status);
}
