/* SPDX-License-Identifier: MIT */
#include "qtri_port/ili9488.h"

#include "internal.h"

static const qtri_panel_step init[] = {
    QTRI_STEP_ALONE(0x01, 120), /* software reset, for modules without the pin */
    QTRI_STEP(0xE0, 0, 0x00, 0x03, 0x09, 0x08, 0x16, 0x0A, 0x3F, 0x78, 0x4C, 0x09, 0x0A, 0x08, 0x16,
              0x1A, 0x0F), /* gamma for positive and negative voltages */
    QTRI_STEP(0xE1, 0, 0x00, 0x16, 0x19, 0x03, 0x0F, 0x05, 0x32, 0x45, 0x46, 0x04, 0x0E, 0x0D, 0x35,
              0x37, 0x0F),
    QTRI_STEP(0xC0, 0, 0x17, 0x15),       /* VREG1 5.00 V, VREG2 -4.69 V */
    QTRI_STEP(0xC1, 0, 0x41),             /* VGH 6 VCI, VGL -4 VCI */
    QTRI_STEP(0xC5, 0, 0x00, 0x12, 0x80), /* VCOM -1.71 V, from this register */
    QTRI_STEP(0x3A, 0, 0x66),             /* pixel format: 18 bits, all that its SPI takes */
    QTRI_STEP(0xB0, 0, 0x00),             /* polarity of signals */
    QTRI_STEP(0xB1, 0, 0xA0),             /* 60 frames a second */
    QTRI_STEP(0xB4, 0, 0x02),             /* neighbours of opposite polarity, two dots at a time */
    QTRI_STEP(0xB6, 0, 0x02, 0x02, 0x3B), /* 480 lines, from the memory */
    QTRI_STEP(0xB7, 0, 0xC6),             /* entry mode */
    QTRI_STEP(0xF7, 0, 0xA9, 0x51, 0x2C, 0x82), /* fewer bits by dithering its own */
    QTRI_STEP_ALONE(0x11, 120),                 /* sleep out */
    QTRI_STEP_ALONE(0x29, 25),                  /* display on */
};

/* Address mode: rows reversed 0x80, columns reversed 0x40, exchanged 0x20, blue first 0x08. */
const qtri_panel_description qtri_ili9488 = {
    .width = 320,
    .height = 480,
    .format = QTRI_PANEL_RGB666,
    .init = init,
    .init_count = sizeof init / sizeof init[0],
    .parameters_are_data = true,
    .reset_ms = 1,
    .start_ms = 120,
    .orientation_command = 0x36,
    .orientation = {0x48, 0x28, 0x88, 0xE8},
    .rows_bit = QTRI_MIPI_ROWS,
    .columns_bit = QTRI_MIPI_COLUMNS,
    .red_blue_bit = QTRI_MIPI_RED_BLUE,
    .memory_width = 320,
    .memory_height = 480,
    .window = qtri_panel_mipi_window,
    .write = qtri_panel_write_666,
    .invert_commands = {0x20, 0x21},
};
