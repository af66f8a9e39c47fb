/* SPDX-License-Identifier: MIT */
/*
 * Arm's UART PL011 (DDI 0183), polled: the console of Versatile boards and, renamed, of TI's
 * Stellaris microcontrollers.
 */
#ifndef QTRI_BOARD_PL011_H
#define QTRI_BOARD_PL011_H

#include <stdint.h>

/* Registers, in words. */
enum {
    PL011_DATA = 0x00 / 4,
    PL011_FLAGS = 0x18 / 4,
    PL011_BAUD_WHOLE = 0x24 / 4,
    PL011_BAUD_64TH = 0x28 / 4,
    PL011_LINE = 0x2C / 4,
    PL011_CONTROL = 0x30 / 4
};
#define PL011_FLAGS_RX_EMPTY (1u << 4)
#define PL011_FLAGS_TX_FULL  (1u << 5)
#define PL011_LINE_8N1_FIFO  0x70u
#define PL011_CONTROL_ON     0x301u /* the UART, its transmitter and its receiver */

/* The divisor is clock / (16 baud), rounded to 1/64. */
static inline void pl011_init(volatile uint32_t *uart, uint32_t clock_hz, uint32_t baud)
{
    uint32_t divisor_64ths = (clock_hz * 4u + baud / 2u) / baud; /* clock < 1 GHz */
    uart[PL011_CONTROL] = 0;
    uart[PL011_BAUD_WHOLE] = divisor_64ths / 64u;
    uart[PL011_BAUD_64TH] = divisor_64ths % 64u;
    uart[PL011_LINE] = PL011_LINE_8N1_FIFO; /* takes over the divisor */
    uart[PL011_CONTROL] = PL011_CONTROL_ON;
}

static inline void pl011_write(volatile uint32_t *uart, const char *text)
{
    for (; *text != '\0'; text++) {
        while ((uart[PL011_FLAGS] & PL011_FLAGS_TX_FULL) != 0) {
        }
        uart[PL011_DATA] = (uint8_t)*text;
    }
}

static inline uint8_t pl011_read(volatile uint32_t *uart)
{
    while ((uart[PL011_FLAGS] & PL011_FLAGS_RX_EMPTY) != 0) {
    }
    return (uint8_t)uart[PL011_DATA];
}

#endif
