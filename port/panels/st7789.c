/* SPDX-License-Identifier: MIT */
#include "qtri_port/st7789.h"

#include "internal.h"

/* Porches, voltages and gamma stay at the chip's reset values. */
static const qtri_panel_step init[] = {
    QTRI_STEP_ALONE(0x01, 120), /* software reset, for modules without the pin */
    QTRI_STEP_ALONE(0x11, 120), /* sleep out */
    QTRI_STEP(0x3A, 0, 0x55),   /* pixel format: 16 bits on the bus and in memory */
    QTRI_STEP_ALONE(0x13, 10),  /* the whole display, not a part */
    QTRI_STEP_ALONE(0x29, 10),  /* display on */
};

/* Address mode: rows reversed 0x80, columns reversed 0x40, exchanged 0x20. */
#define ST7789(glass_width, glass_height, column, row)                                             \
    {                                                                                              \
        .width = (glass_width), .height = (glass_height), .format = QTRI_PANEL_RGB565,             \
        .order = QTRI_ORDER_BIG, .init = init, .init_count = sizeof init / sizeof init[0],         \
        .parameters_are_data = true, .reset_ms = 1, .start_ms = 120, .orientation_command = 0x36,  \
        .orientation = {0x00, 0x60, 0xC0, 0xA0}, .memory_width = 240, .memory_height = 320,        \
        .first_column = (column), .first_row = (row), .window = qtri_panel_mipi_window,            \
        .inverted = true, .invert_commands = {                                                     \
            0x20,                                                                                  \
            0x21                                                                                   \
        }                                                                                          \
    }

const qtri_panel_description qtri_st7789 = ST7789(240, 320, 0, 0);
const qtri_panel_description qtri_st7789_240x240 = ST7789(240, 240, 0, 0);
const qtri_panel_description qtri_st7789_135x240 = ST7789(135, 240, 52, 40);
const qtri_panel_description qtri_st7789_170x320 = ST7789(170, 320, 35, 0);
