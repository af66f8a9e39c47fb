/* SPDX-License-Identifier: MIT */
/*
 * What this board uses of the RP2040 (Raspberry Pi, RP2040 Datasheet): register addresses, in
 * words, and the few accesses that need more than one line.
 */
#ifndef QTRI_BOARD_RP2040_H
#define QTRI_BOARD_RP2040_H

#include <stdint.h>

#define CLOCK_HZ 125000000u /* what board_init makes it: the processor's and the peripherals' */

/* Aliases of a peripheral's registers that set or clear the bits written, section 2.1.2. */
#define SET(peripheral)   ((peripheral) + 0x2000 / 4)
#define CLEAR(peripheral) ((peripheral) + 0x3000 / 4)

/* Subsystem resets, section 2.14: everything that is used is held in reset at first. */
#define RESETS ((volatile uint32_t *)0x4000C000u)
enum { RESET = 0x0 / 4, RESET_DONE = 0x8 / 4 };
#define RESET_DMA     (1u << 2)
#define RESET_PINS    (1u << 5)
#define RESET_PADS    (1u << 8)
#define RESET_PLL_SYS (1u << 12)
#define RESET_SPI0    (1u << 16)
#define RESET_TIMER   (1u << 21)
#define RESET_UART0   (1u << 22)

/* Crystal oscillator, section 2.16. */
#define XOSC ((volatile uint32_t *)0x40024000u)
enum { XOSC_CONTROL = 0x00 / 4, XOSC_STATUS = 0x04 / 4, XOSC_STARTUP = 0x0C / 4 };
#define XOSC_ENABLE_1_TO_15_MHZ 0xFABAA0u
#define XOSC_STABLE             (1u << 31)

/* The system's PLL, section 2.18. */
#define PLL_SYS ((volatile uint32_t *)0x40028000u)
enum {
    PLL_STATUS = 0x0 / 4,
    PLL_POWER_DOWN = 0x4 / 4,
    PLL_FEEDBACK = 0x8 / 4,
    PLL_DIVIDERS = 0xC / 4
};
#define PLL_LOCKED          (1u << 31)
#define PLL_DOWN_MAIN       (1u << 0)
#define PLL_DOWN_DIVIDERS   (1u << 3)
#define PLL_DOWN_OSCILLATOR (1u << 5)
#define PLL_DIVIDE_BY(a, b) ((uint32_t)(a) << 16 | (uint32_t)(b) << 12)

/* Clocks, section 2.15. A bit of _SELECTED tells which source is in use. */
#define CLOCKS ((volatile uint32_t *)0x40008000u)
enum {
    CLOCK_REF = 0x30 / 4,
    CLOCK_REF_SELECTED = 0x38 / 4,
    CLOCK_SYS = 0x3C / 4,
    CLOCK_SYS_SELECTED = 0x44 / 4,
    CLOCK_PERI = 0x48 / 4
};
#define CLOCK_REF_XOSC 2u
#define CLOCK_SYS_PLL  1u
#define CLOCK_PERI_ON  (1u << 11) /* from CLOCK_SYS */

/* The microsecond timer, section 4.6, counts ticks that the watchdog, section 4.7, makes. */
#define TIMER ((volatile uint32_t *)0x40054000u)
enum { TIMER_LOW = 0x28 / 4 };
#define WATCHDOG ((volatile uint32_t *)0x40058000u)
enum { WATCHDOG_TICK = 0x2C / 4 };
#define WATCHDOG_TICK_ON (1u << 9)

/* Pins: functions, section 2.19, and levels, section 2.3.1. */
#define PINS ((volatile uint32_t *)0x40014000u)
enum { PIN_SPI = 1, PIN_UART = 2, PIN_SIO = 5 };
#define SIO ((volatile uint32_t *)0xD0000000u)
enum { SIO_OUT_SET = 0x14 / 4, SIO_OUT_CLEAR = 0x18 / 4, SIO_OUTPUT_SET = 0x24 / 4 };

#define UART0 ((volatile uint32_t *)0x40034000u) /* section 4.2: a PL011 */

/* SPI, section 4.4: Arm's PL022. */
#define SPI0 ((volatile uint32_t *)0x4003C000u)
enum {
    SPI_CONTROL_0 = 0x00 / 4,
    SPI_CONTROL_1 = 0x04 / 4,
    SPI_DATA = 0x08 / 4,
    SPI_STATUS = 0x0C / 4,
    SPI_PRESCALE = 0x10 / 4,
    SPI_DMA = 0x24 / 4
};
#define SPI_CONTROL_0_8_BITS       7u /* mode 0 */
#define SPI_CONTROL_0_DIVIDE_BY(n) (((n)-1u) << 8)
#define SPI_CONTROL_1_ON           2u
#define SPI_STATUS_NOT_FULL        (1u << 1)
#define SPI_STATUS_BUSY            (1u << 4)
#define SPI_DMA_SENDS              2u

/* DMA, section 2.5; writing CONTROL starts the channel. */
#define DMA_CHANNEL_0 ((volatile uint32_t *)0x50000000u)
enum { DMA_READ = 0x0 / 4, DMA_WRITE = 0x4 / 4, DMA_COUNT = 0x8 / 4, DMA_CONTROL = 0xC / 4 };
#define DMA_BYTES_TO_SPI0                                                                          \
    (1u << 0 | 1u << 4 | 16u << 15) /* on; the address counts up; SPI 0 asks */
#define DMA_BUSY (1u << 24)

static inline void release_from_reset(uint32_t subsystems)
{
    CLEAR(RESETS)[RESET] = subsystems;
    while ((~RESETS[RESET_DONE] & subsystems) != 0) {
    }
}

static inline void pin_function(uint32_t pin, uint32_t function)
{
    PINS[2u * pin + 1u] = function;
}

static inline void pin_write(uint32_t pin, uint32_t high)
{
    SIO[high != 0 ? SIO_OUT_SET : SIO_OUT_CLEAR] = 1u << pin;
}

static inline void pin_output(uint32_t pin, uint32_t high)
{
    pin_write(pin, high);
    SIO[SIO_OUTPUT_SET] = 1u << pin;
    pin_function(pin, PIN_SIO);
}

#endif
