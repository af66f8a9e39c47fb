/* SPDX-License-Identifier: MIT */
/*
 * TI (Luminary) LM3S6965 evaluation board (QEMU lm3s6965evb): Cortex-M3 at 50 MHz, console on
 * UART 0, instructions by SysTick. The OLED is in oled.c; the start-up code is that of ../mps2.
 */
#include "../board.h"
#include "../display.h"

#include "../common/pl011.h"
#include "../common/semihosting.h"
#include "lm3s6965.h"

#define BAUD     115200u
#define PIN_UART (1u << 0 | 1u << 1) /* of port A */

/* With -icount shift=0 an instruction takes 1 ns, a tick of the 50 MHz clock 20 ns. */
#define INSTRUCTIONS_PER_TICK (1000000000u / CLOCK_HZ)

/* From the crystal of 8 MHz the PLL makes 200 MHz; the divider makes 50. */
static void start_clock(void)
{
    uint32_t clock = SYSTEM[RUN_CLOCK] | RUN_CLOCK_BYPASS_PLL;
    clock &= ~(RUN_CLOCK_USE_DIVIDER | RUN_CLOCK_CRYSTAL_OFF);
    SYSTEM[RUN_CLOCK] = clock;
    clock &= ~(RUN_CLOCK_PLL_OFF | RUN_CLOCK_CRYSTAL_MASK | RUN_CLOCK_SOURCE_MASK |
               RUN_CLOCK_DIVIDER_MASK);
    clock |= RUN_CLOCK_CRYSTAL_8_MHZ | RUN_CLOCK_DIVIDE_BY(4u) | RUN_CLOCK_USE_DIVIDER;
    SYSTEM[RUN_CLOCK] = clock;
    while ((SYSTEM[INTERRUPT_STATUS] & INTERRUPT_PLL_LOCKED) == 0) {
    }
    SYSTEM[RUN_CLOCK] = clock & ~RUN_CLOCK_BYPASS_PLL;
}

void board_init(void)
{
    start_clock();
    enable(CLOCK_GATE_1, CLOCK_1_UART0);
    enable(CLOCK_GATE_2, CLOCK_2_GPIO_A);
    gpio_function(GPIO_A, PIN_UART);
    pl011_init(UART0, CLOCK_HZ, BAUD);
    SYSTICK[SYSTICK_RELOAD] = SYSTICK_MAX;
    SYSTICK[SYSTICK_VALUE] = 0; /* any write clears it */
    SYSTICK[SYSTICK_CONTROL] = SYSTICK_ENABLE | SYSTICK_CORE_CLOCK;
}

void board_write(const char *text)
{
    pl011_write(UART0, text);
}

void board_wait_for_key(void)
{
    (void)pl011_read(UART0);
}

uint32_t board_ticks(void)
{
    return SYSTICK[SYSTICK_VALUE];
}

/* Good for up to 2^24 ticks: 335 million instructions. */
uint32_t board_instructions(uint32_t from_ticks, uint32_t to_ticks)
{
    return ((from_ticks - to_ticks) & SYSTICK_MAX) * INSTRUCTIONS_PER_TICK;
}

void board_exit(int status)
{
    semihosting_exit(status);
}
