/* SPDX-License-Identifier: MIT */
#include "qtri_port/ili9341.h"

#include "internal.h"

/* Voltages, timing and gamma stay at the chip's reset values; modules work with them. */
static const qtri_panel_step init[] = {
    QTRI_STEP_ALONE(0x01, 120), /* software reset, for modules without the pin; 120 ms in sleep */
    QTRI_STEP(0x3A, 0, 0x55),   /* pixel format: 16 bits */
    QTRI_STEP(0x26, 0, 0x01),   /* gamma curve 1 */
    QTRI_STEP_ALONE(0x11, 120), /* sleep out: supplies and oscillator start */
    QTRI_STEP_ALONE(0x29, 0),   /* display on */
};

/* Address mode: rows reversed 0x80, columns reversed 0x40, exchanged 0x20, blue first 0x08. */
const qtri_panel_description qtri_ili9341 = {
    .width = 240,
    .height = 320,
    .format = QTRI_PANEL_RGB565,
    .order = QTRI_ORDER_BIG,
    .init = init,
    .init_count = sizeof init / sizeof init[0],
    .parameters_are_data = true,
    .reset_ms = 1, /* 10 us */
    .start_ms = 120,
    .orientation_command = 0x36,
    .orientation = {0x48, 0x28, 0x88, 0xE8},
    .memory_width = 240,
    .memory_height = 320,
    .window = qtri_panel_mipi_window,
    .invert_commands = {0x20, 0x21},
};
