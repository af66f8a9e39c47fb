/* SPDX-License-Identifier: MIT */
/*
 * A bus: how bytes reach a display. The user fills in a few functions; nothing else of the port
 * touches hardware.
 *
 * 4-wire SPI, the usual case: chip select, clock, data out, and a D/C pin that is low for commands
 * and high for data. `command` and `data` select the chip, set the pin, send, and may leave the
 * chip selected or not: no display here minds. SPI mode 0 (or 3), most significant bit first.
 * Clocks that the controllers stand when written to: SSD0323 4 MHz, SSD1306 and ILI9341 10 MHz
 * (ILI9341 40 in practice), SSD1680 20 MHz, ST7789 62 MHz; I2C 400 kHz.
 *
 * I2C: i2c.h makes a bus out of one function. Parallel (8080) buses: D/C is called RS.
 */
#ifndef QTRI_PORT_BUS_H
#define QTRI_PORT_BUS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/*
 * Functions get `context` as it is here and return true when the bytes were sent; false (no
 * acknowledge, a DMA error) ends the panel's function with QTRI_ERROR_BUS. They are not called from
 * interrupts. Those marked so may be NULL.
 */
typedef struct qtri_bus {
    void *context;

    /* Sends count bytes, 1..17, with D/C low. Returns when D/C may change: after the last bit. */
    bool (*command)(void *context, const uint8_t *bytes, size_t count);

    /* Sends count bytes, 1 or more, with D/C high. Returns when the bytes may be overwritten and
       D/C may change. */
    bool (*data)(void *context, const uint8_t *bytes, size_t count);

    /* DMA, or NULL, both: `data` sends pixels then. data_start sets D/C high, starts the transfer
       and returns at once; the bytes stay untouched and nothing else is called until data_finish,
       which waits for the last bit, also before an error is returned. A start that returned true is
       followed by exactly one finish; one that returned false by none: nothing was started, and
       pins and DMA are as they were before it. A finish that returned false has ended the transfer
       all the same and is not repeated. */
    bool (*data_start)(void *context, const uint8_t *bytes, size_t count);
    bool (*data_finish)(void *context);

    /* Returns after ms milliseconds or more. */
    void (*wait_ms)(void *context, uint32_t ms);

    /* Drives the reset pin: true resets (low). NULL where the pin is not wired. */
    void (*reset)(void *context, bool active);

    /* True while the controller is busy: e-paper's BUSY pin. NULL where there is none: the panel
       then waits as long as its controller mostly takes. */
    bool (*busy)(void *context);

    /* The most bytes that `data` and `data_start` are given at once, as 65535 for many DMA engines;
       longer ones are split. 0: any number. Others than 0 are even and 16 or more: the
       parameters of a command are not split. */
    size_t most_bytes;
} qtri_bus;

#ifdef __cplusplus
}
#endif

#endif
