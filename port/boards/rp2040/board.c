/* SPDX-License-Identifier: MIT */
/*
 * RP2040 (Raspberry Pi Pico, rp2040js): a Cortex-M0+ at 125 MHz, console on UART 0 (pins 0 and 1),
 * time by the microsecond timer. The display is in lcd.c; the start-up code is that of ../mps2.
 */
#include "../board.h"
#include "../display.h"

#include "../common/pl011.h"
#include "../common/semihosting.h"
#include "rp2040.h"

#define BAUD       115200u
#define CRYSTAL_HZ 12000000u

/* From the crystal of 12 MHz the PLL makes 1500; its dividers make 125. */
static void start_clock(void)
{
    XOSC[XOSC_STARTUP] = CRYSTAL_HZ / 1000u / 256u; /* 1 ms, in 256 of its cycles */
    XOSC[XOSC_CONTROL] = XOSC_ENABLE_1_TO_15_MHZ;
    while ((XOSC[XOSC_STATUS] & XOSC_STABLE) == 0) {
    }
    CLOCKS[CLOCK_REF] = CLOCK_REF_XOSC;
    while ((CLOCKS[CLOCK_REF_SELECTED] & 1u << CLOCK_REF_XOSC) == 0) {
    }
    release_from_reset(RESET_PLL_SYS);
    PLL_SYS[PLL_FEEDBACK] = 125;
    CLEAR(PLL_SYS)[PLL_POWER_DOWN] = PLL_DOWN_MAIN | PLL_DOWN_OSCILLATOR;
    while ((PLL_SYS[PLL_STATUS] & PLL_LOCKED) == 0) {
    }
    PLL_SYS[PLL_DIVIDERS] = PLL_DIVIDE_BY(6, 2);
    CLEAR(PLL_SYS)[PLL_POWER_DOWN] = PLL_DOWN_DIVIDERS;
    CLOCKS[CLOCK_SYS] = CLOCK_SYS_PLL;
    while ((CLOCKS[CLOCK_SYS_SELECTED] & 1u << CLOCK_SYS_PLL) == 0) {
    }
    CLOCKS[CLOCK_PERI] = CLOCK_PERI_ON;
    WATCHDOG[WATCHDOG_TICK] = WATCHDOG_TICK_ON | CRYSTAL_HZ / 1000000u;
}

void board_init(void)
{
    start_clock();
    release_from_reset(RESET_PINS | RESET_PADS | RESET_TIMER | RESET_UART0);
    pin_function(0, PIN_UART);
    pin_function(1, PIN_UART);
    pl011_init(UART0, CLOCK_HZ, BAUD);
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
    return TIMER[TIMER_LOW];
}

/* Cycles: good for up to 34 seconds. */
uint32_t board_instructions(uint32_t from_ticks, uint32_t to_ticks)
{
    return (to_ticks - from_ticks) * (CLOCK_HZ / 1000000u);
}

void board_exit(int status)
{
    semihosting_exit(status);
}
