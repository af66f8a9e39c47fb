/* SPDX-License-Identifier: MIT */
#include "chip.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

void chip_reject(chip *it, const char *format, ...)
{
    if (it->error[0] != '\0') {
        return;
    }
    int n = snprintf(it->error, sizeof it->error, "%s: ", it->model->name);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(it->error + n, sizeof it->error - (size_t)n, format, arguments);
    va_end(arguments);
}

void chip_allow(chip *it, bool allowed)
{
    if (!allowed) {
        chip_reject(it, "command 0x%02X: parameter 0x%02X", it->command, it->parameters[0]);
    }
}

void chip_allow_range(chip *it, int first, int last, int most)
{
    if (first > last || last > most) {
        chip_reject(it, "command 0x%02X: range %d..%d", it->command, first, last);
    }
}

void chip_open_window(chip *it, const int x[2], const int y[2], int at_x, int at_y)
{
    const chip_window window = {x[0], x[1], y[0], y[1], at_x, at_y, true, false};
    it->window = window;
}

static void forget(chip *it)
{
    chip_window empty = {0, 0, 0, 0, 0, 0, false, false};
    it->window = empty;
    it->command = 0;
    it->count = it->expected = 0;
}

void chip_init(chip *it, const chip_model *model)
{
    it->model = model;
    it->error[0] = '\0';
    it->now_ms = it->ready_ms = 0;
    it->in_reset = it->started = it->busy_pin = false;
    forget(it);
    model->reset(it);
}

void chip_wait(chip *it, uint32_t ms)
{
    it->now_ms += ms;
}

void chip_reset_pin(chip *it, bool active)
{
    if (it->in_reset && !active) {
        forget(it);
        it->started = true;
        it->model->reset(it);
    }
    it->in_reset = active;
}

bool chip_busy(const chip *it)
{
    return it->now_ms < it->ready_ms;
}

static void finish_command(chip *it)
{
    if (it->expected != CHIP_STREAM && it->count < it->expected) {
        chip_reject(it, "command 0x%02X has %d parameters, not %d", it->command, it->expected,
                    it->count);
    }
}

static void take_command(chip *it, uint8_t byte)
{
    finish_command(it);
    if (!it->started) {
        chip_reject(it, "command 0x%02X without a reset", byte);
    }
    if (chip_busy(it)) {
        chip_reject(it, "command 0x%02X %d ms too early", byte, (int)(it->ready_ms - it->now_ms));
    }
    it->command = byte;
    it->count = it->expected = 0;
    for (size_t i = 0; i < it->model->command_count; i++) {
        const chip_command *known = &it->model->commands[i];
        if (byte >= known->first && byte <= known->last) {
            it->expected = known->parameters;
            if (it->expected <= 0) {
                it->model->execute(it);
            }
            return;
        }
    }
    chip_reject(it, "unknown command 0x%02X", byte);
}

static void take_parameter(chip *it, uint8_t byte)
{
    if (it->count >= it->expected) {
        chip_reject(it, "command 0x%02X has %d parameters, not more", it->command, it->expected);
        return;
    }
    it->parameters[it->count++] = byte;
    if (it->count == it->expected) {
        it->model->execute(it);
    }
}

static void take_pixels(chip *it, uint8_t byte)
{
    if (!it->window.set) {
        chip_reject(it, "data without a window");
    } else if (it->window.full) {
        chip_reject(it, "data past the end of the window");
    } else {
        it->model->store(it, byte);
    }
}

void chip_send(chip *it, bool is_data, const uint8_t *bytes, size_t count)
{
    bool mixed = it->model->parameters_are_data;
    for (size_t i = 0; i < count && it->error[0] == '\0'; i++) {
        if (it->in_reset) {
            chip_reject(it, "a byte during reset");
        } else if (!is_data) {
            if (!mixed && it->count < it->expected) {
                take_parameter(it, bytes[i]);
            } else {
                take_command(it, bytes[i]);
            }
        } else if (mixed && it->expected != CHIP_STREAM) {
            take_parameter(it, bytes[i]);
        } else {
            finish_command(it);
            take_pixels(it, bytes[i]);
        }
    }
}

/* Bit 7 (Co) of a control byte: one byte follows, then another control byte; bit 6: it is data. */
void chip_i2c(chip *it, const uint8_t *bytes, size_t count)
{
    size_t i = 0;
    while (i < count) {
        uint8_t control = bytes[i++];
        if ((control & 0x3F) != 0) {
            chip_reject(it, "control byte 0x%02X", control);
            return;
        }
        size_t n = (control & 0x80) != 0 ? 1 : count - i;
        if (n == 0 || n > count - i) {
            chip_reject(it, "control byte 0x%02X and nothing after it", control);
            return;
        }
        chip_send(it, (control & 0x40) != 0, bytes + i, n);
        i += n;
    }
}

uint32_t chip_pixel(const chip *it, int x, int y)
{
    return it->model->pixel(it, x, y);
}

/* One step from `at` towards `last`; from there back to `first`: true. */
static bool step(int *at, int first, int last)
{
    if (*at == last) {
        *at = first;
        return true;
    }
    *at += first <= last ? 1 : -1;
    return false;
}

void chip_advance(chip *it, bool vertical)
{
    chip_window *w = &it->window;
    if (vertical) {
        w->full = step(&w->y, w->y0, w->y1) && step(&w->x, w->x0, w->x1);
    } else {
        w->full = step(&w->x, w->x0, w->x1) && step(&w->y, w->y0, w->y1);
    }
}
