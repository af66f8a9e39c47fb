/* SPDX-License-Identifier: MIT */
#include "qtri_port/st7735.h"

#include "internal.h"

/* Frame rates, voltages and gamma stay at the chip's reset values. */
static const qtri_panel_step init[] = {
    QTRI_STEP_ALONE(0x01, 120), /* software reset, for modules without the pin */
    QTRI_STEP_ALONE(0x11, 120), /* sleep out */
    QTRI_STEP(0x3A, 0, 0x05),   /* pixel format: 16 bits */
    QTRI_STEP_ALONE(0x13, 10),  /* the whole display, not a part */
    QTRI_STEP_ALONE(0x29, 10),  /* display on */
};

/*
 * Address mode: rows reversed 0x80, columns reversed 0x40, exchanged 0x20, blue first 0x08. Glass
 * stands on its head on the chip.
 */
#define ST7735(glass_width, glass_height, across, down, column, row, is_inverted)                  \
    {                                                                                              \
        .width = (glass_width), .height = (glass_height), .format = QTRI_PANEL_RGB565,             \
        .order = QTRI_ORDER_BIG, .init = init, .init_count = sizeof init / sizeof init[0],         \
        .parameters_are_data = true, .reset_ms = 1, .start_ms = 120, .orientation_command = 0x36,  \
        .orientation = {0xC8, 0xA8, 0x08, 0x68}, .memory_width = (across),                         \
        .memory_height = (down), .first_column = (column), .first_row = (row),                     \
        .window = qtri_panel_mipi_window, .inverted = (is_inverted),                               \
        .invert_commands = {0x20, 0x21},                                                           \
    }

/* Pins of the module tell the chip how much memory it has: 128x160 or 132x162. */
const qtri_panel_description qtri_st7735 = ST7735(128, 160, 128, 160, 0, 0, false);
const qtri_panel_description qtri_st7735_green = ST7735(128, 160, 132, 162, 2, 1, false);
const qtri_panel_description qtri_st7735_80x160 = ST7735(80, 160, 132, 162, 26, 1, true);
