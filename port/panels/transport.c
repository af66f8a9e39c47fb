/* SPDX-License-Identifier: MIT */
#include "internal.h"

#include <string.h>

static enum qtri_error sent(bool ok)
{
    return ok ? QTRI_OK : QTRI_ERROR_BUS;
}

enum qtri_error qtri_panel_command(const qtri_panel *panel, uint8_t command,
                                   const uint8_t *parameters, uint8_t count)
{
    const qtri_bus *bus = panel->bus;
    uint8_t bytes[1 + QTRI_STEP_PARAMETERS];
    if (count > QTRI_STEP_PARAMETERS) {
        return QTRI_ERROR_SIZE;
    }
    bytes[0] = command;
    if (count > 0) {
        memcpy(bytes + 1, parameters, count);
    }
    if (!panel->description->parameters_are_data) {
        return sent(bus->command(bus->context, bytes, count + (size_t)1));
    }
    return sent(bus->command(bus->context, bytes, 1) &&
                (count == 0 || bus->data(bus->context, bytes + 1, count)));
}

/* One transfer. */
static enum qtri_error transfer(qtri_panel *panel, const uint8_t *bytes, size_t count)
{
    const qtri_bus *bus = panel->bus;
    if (bus->data_start == NULL) {
        return sent(bus->data(bus->context, bytes, count));
    }
    enum qtri_error error = qtri_panel_finish(panel);
    if (error == QTRI_OK) {
        error = sent(bus->data_start(bus->context, bytes, count));
        panel->sending = error == QTRI_OK;
    }
    return error;
}

enum qtri_error qtri_panel_data(qtri_panel *panel, const uint8_t *bytes, size_t count)
{
    size_t most = panel->bus->most_bytes == 0 ? count : panel->bus->most_bytes;
    enum qtri_error error = QTRI_OK;
    while (count > 0 && error == QTRI_OK) {
        size_t n = count < most ? count : most;
        error = transfer(panel, bytes, n);
        bytes += n;
        count -= n;
    }
    return error;
}

enum qtri_error qtri_panel_finish(qtri_panel *panel)
{
    QTRI_ASSERT(panel != NULL && panel->description != NULL);
    if (!panel->sending) {
        return QTRI_OK;
    }
    panel->sending = false;
    return sent(panel->bus->data_finish(panel->bus->context));
}

enum qtri_error qtri_panel_open(qtri_panel *panel, const qtri_rect *bytes)
{
    enum qtri_error error = qtri_panel_finish(panel);
    return error == QTRI_OK ? panel->description->window(panel, bytes) : error;
}

static enum qtri_error wait_until_ready(const qtri_panel *panel)
{
    const qtri_bus *bus = panel->bus;
    if (bus->busy == NULL) {
        bus->wait_ms(bus->context, panel->description->blind_ms);
        return QTRI_OK;
    }
    for (uint32_t ms = 0; bus->busy(bus->context); ms++) {
        if (ms >= panel->description->busy_ms) {
            return QTRI_ERROR_BUS;
        }
        bus->wait_ms(bus->context, 1);
    }
    return QTRI_OK;
}

enum qtri_error qtri_panel_send(qtri_panel *panel, const qtri_panel_step *steps, size_t count)
{
    QTRI_ASSERT(panel != NULL && panel->description != NULL);
    QTRI_ASSERT(steps != NULL || count == 0);
    if (panel->bus == NULL || steps == NULL) {
        return QTRI_OK;
    }
    enum qtri_error error = qtri_panel_finish(panel);
    for (size_t i = 0; i < count && error == QTRI_OK; i++) {
        const qtri_panel_step *step = &steps[i];
        error = qtri_panel_command(panel, step->command, step->parameters, step->count);
        if (error == QTRI_OK && step->wait_ms == QTRI_STEP_UNTIL_READY) {
            error = wait_until_ready(panel);
        } else if (error == QTRI_OK && step->wait_ms != 0) {
            panel->bus->wait_ms(panel->bus->context, step->wait_ms);
        }
    }
    return error;
}
