/* SPDX-License-Identifier: MIT */
/*
 * What this board uses of the LM3S6965 (TI, data sheet SPMS035): register addresses, in words, and
 * the few accesses that need more than one line.
 */
#ifndef QTRI_BOARD_LM3S6965_H
#define QTRI_BOARD_LM3S6965_H

#include <stdint.h>

#define CLOCK_HZ 50000000u /* what board_init makes it */

/* System control, chapter 6. */
#define SYSTEM ((volatile uint32_t *)0x400FE000u)
enum {
    INTERRUPT_STATUS = 0x050 / 4,
    RUN_CLOCK = 0x060 / 4,
    CLOCK_GATE_1 = 0x104 / 4,
    CLOCK_GATE_2 = 0x108 / 4
};
#define INTERRUPT_PLL_LOCKED    (1u << 6)
#define RUN_CLOCK_DIVIDE_BY(n)  (((n)-1u) << 23)
#define RUN_CLOCK_DIVIDER_MASK  (15u << 23)
#define RUN_CLOCK_USE_DIVIDER   (1u << 22)
#define RUN_CLOCK_PLL_OFF       (1u << 13)
#define RUN_CLOCK_BYPASS_PLL    (1u << 11)
#define RUN_CLOCK_CRYSTAL_MASK  (15u << 6)
#define RUN_CLOCK_CRYSTAL_8_MHZ (14u << 6)
#define RUN_CLOCK_SOURCE_MASK   (3u << 4) /* 0: the crystal */
#define RUN_CLOCK_CRYSTAL_OFF   (1u << 0)
#define CLOCK_1_UART0           (1u << 0)
#define CLOCK_1_SSI0            (1u << 4)
#define CLOCK_2_GPIO_A          (1u << 0)
#define CLOCK_2_GPIO_C          (1u << 2)
#define CLOCK_2_GPIO_D          (1u << 3)

/* General-purpose pins, chapter 9. */
#define GPIO_A ((volatile uint32_t *)0x40004000u)
#define GPIO_C ((volatile uint32_t *)0x40006000u)
#define GPIO_D ((volatile uint32_t *)0x40007000u)
enum { GPIO_DIRECTION = 0x400 / 4, GPIO_FUNCTION = 0x420 / 4, GPIO_DIGITAL = 0x51C / 4 };

#define UART0 ((volatile uint32_t *)0x4000C000u) /* chapter 13: a PL011 */

/* Synchronous serial interface, chapter 14. */
#define SSI0 ((volatile uint32_t *)0x40008000u)
enum {
    SSI_CONTROL_0 = 0x00 / 4,
    SSI_CONTROL_1 = 0x04 / 4,
    SSI_DATA = 0x08 / 4,
    SSI_STATUS = 0x0C / 4,
    SSI_PRESCALE = 0x10 / 4
};
#define SSI_CONTROL_0_8_BITS 7u /* mode 0 */
#define SSI_CONTROL_1_ON     2u
#define SSI_STATUS_RECEIVED  4u

/* The processor's timer counts down, 24 bits. */
#define SYSTICK ((volatile uint32_t *)0xE000E010u)
enum { SYSTICK_CONTROL, SYSTICK_RELOAD, SYSTICK_VALUE };
#define SYSTICK_ENABLE     1u
#define SYSTICK_CORE_CLOCK 4u
#define SYSTICK_MAX        0xFFFFFFu

/* Gives clocks to peripherals; they answer a few clocks later, so the register is read back. */
static inline void enable(uint32_t gate, uint32_t peripherals)
{
    SYSTEM[gate] |= peripherals;
    (void)SYSTEM[gate];
    (void)SYSTEM[gate];
}

static inline void gpio_function(volatile uint32_t *port, uint32_t pins)
{
    port[GPIO_FUNCTION] |= pins;
    port[GPIO_DIGITAL] |= pins;
}

static inline void gpio_output(volatile uint32_t *port, uint32_t pins)
{
    port[GPIO_DIRECTION] |= pins;
    port[GPIO_DIGITAL] |= pins;
}

/* The pins of the mask only: bits 2..9 of the address are the mask. */
static inline void gpio_write(volatile uint32_t *port, uint32_t mask, uint32_t value)
{
    port[mask] = value;
}

#endif
