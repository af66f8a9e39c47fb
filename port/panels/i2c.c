/* SPDX-License-Identifier: MIT */
#include "qtri_port/i2c.h"

#include "qtri/error.h"

#include <string.h>

enum { CONTROL_COMMANDS = 0x00, CONTROL_DATA = 0x40 };

static bool send(qtri_i2c *i2c, uint8_t control, const uint8_t *bytes, size_t count)
{
    bool ok = true;
    while (count > 0 && ok) {
        size_t n = count < i2c->bytes - 1 ? count : i2c->bytes - 1;
        i2c->buffer[0] = control;
        memcpy(i2c->buffer + 1, bytes, n);
        ok = i2c->write(i2c->context, i2c->buffer, n + 1);
        bytes += n;
        count -= n;
    }
    return ok;
}

static bool command(void *context, const uint8_t *bytes, size_t count)
{
    return send((qtri_i2c *)context, CONTROL_COMMANDS, bytes, count);
}

static bool data(void *context, const uint8_t *bytes, size_t count)
{
    return send((qtri_i2c *)context, CONTROL_DATA, bytes, count);
}

static void wait_ms(void *context, uint32_t ms)
{
    qtri_i2c *i2c = (qtri_i2c *)context;
    i2c->wait_ms(i2c->context, ms);
}

static void reset(void *context, bool active)
{
    qtri_i2c *i2c = (qtri_i2c *)context;
    i2c->reset(i2c->context, active);
}

enum qtri_error qtri_i2c_bus(qtri_bus *bus, qtri_i2c *i2c)
{
    QTRI_ASSERT(bus != NULL && i2c != NULL);
    QTRI_ASSERT(i2c->write != NULL && i2c->wait_ms != NULL);
    QTRI_ASSERT(i2c->buffer != NULL || i2c->bytes == 0);
    if (i2c->bytes < QTRI_I2C_BYTES) {
        return QTRI_ERROR_MEMORY;
    }
    qtri_bus filled = {i2c,  command, data, NULL, NULL, wait_ms, i2c->reset != NULL ? reset : NULL,
                       NULL, 0};
    *bus = filled;
    return QTRI_OK;
}
