/* SPDX-License-Identifier: MIT */
/*
 * A bus for OLEDs on I2C: each transfer begins with a control byte, 0x00 before commands, 0x40
 * before data, and is cut to what the user's buffer holds.
 */
#ifndef QTRI_PORT_I2C_H
#define QTRI_PORT_I2C_H

#include "bus.h"
#include "qtri/error.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The least: a control byte, a command and its parameters. More makes fewer transfers. */
#define QTRI_I2C_BYTES 18

/* An I2C bus: functions of the application, and memory for one transfer. */
typedef struct qtri_i2c {
    void *context; /* of the functions below */

    /* START, the display's address with the write bit, count bytes, STOP. False: no acknowledge. */
    bool (*write)(void *context, const uint8_t *bytes, size_t count);

    void (*wait_ms)(void *context, uint32_t ms); /* as in bus.h */
    void (*reset)(void *context, bool active);   /* as in bus.h, or NULL */
    uint8_t *buffer;                             /* where a transfer is put together */
    size_t bytes;                                /* of buffer, QTRI_I2C_BYTES or more */
} qtri_i2c;

/*
 * Fills in *bus, whose context is i2c: both live as long as the panel.
 * QTRI_ERROR_MEMORY: i2c->bytes < QTRI_I2C_BYTES.
 */
enum qtri_error qtri_i2c_bus(qtri_bus *bus, qtri_i2c *i2c);

#ifdef __cplusplus
}
#endif

#endif
