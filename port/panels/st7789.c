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
        QTRI_MIPI(glass_width, glass_height, 240, 320, column, row, init),                         \
            .orientation = {0x00, 0x60, 0xC0, 0xA0}, .inverted = true                              \
    }

const qtri_panel_description qtri_st7789 = ST7789(240, 320, 0, 0);
const qtri_panel_description qtri_st7789_240x240 = ST7789(240, 240, 0, 0);
const qtri_panel_description qtri_st7789_240x280 = ST7789(240, 280, 0, 20);
const qtri_panel_description qtri_st7789_135x240 = ST7789(135, 240, 52, 40);
const qtri_panel_description qtri_st7789_170x320 = ST7789(170, 320, 35, 0);
const qtri_panel_description qtri_st7789_172x320 = ST7789(172, 320, 34, 0);
