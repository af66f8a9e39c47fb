/* SPDX-License-Identifier: MIT */
#include "qtri_port/st7735.h"

#include "internal.h"

/* What modules are driven with; reset values leave them paler. */
static const qtri_panel_step init[] = {
    QTRI_STEP_ALONE(0x01, 120),                             /* software reset, without the pin */
    QTRI_STEP_ALONE(0x11, 120),                             /* sleep out */
    QTRI_STEP(0xB1, 0, 0x01, 0x2C, 0x2D),                   /* frame rate: normal, */
    QTRI_STEP(0xB2, 0, 0x01, 0x2C, 0x2D),                   /* idle, */
    QTRI_STEP(0xB3, 0, 0x01, 0x2C, 0x2D, 0x01, 0x2C, 0x2D), /* and a part, by dots and by lines */
    QTRI_STEP(0xB4, 0, 0x07),             /* lines of alternating polarity in all of them */
    QTRI_STEP(0xC0, 0, 0xA2, 0x02, 0x84), /* AVDD 5 V, GVDD 4.6 V, GVCL -4.6 V */
    QTRI_STEP(0xC1, 0, 0xC5),             /* VGH 14.7 V, VGL -7.35 V */
    QTRI_STEP(0xC2, 0, 0x0A, 0x00),       /* currents of the amplifiers: normal, */
    QTRI_STEP(0xC3, 0, 0x8A, 0x2A),       /* idle, */
    QTRI_STEP(0xC4, 0, 0x8A, 0xEE),       /* and a part */
    QTRI_STEP(0xC5, 0, 0x0E),             /* VCOM -.775 V */
    QTRI_STEP(0x3A, 0, 0x05),             /* pixel format: 16 bits */
    QTRI_STEP(0xE0, 0, 0x02, 0x1C, 0x07, 0x12, 0x37, 0x32, 0x29, 0x2D, 0x29, 0x25, 0x2B, 0x39, 0x00,
              0x01, 0x03, 0x10), /* gamma for positive and negative voltages */
    QTRI_STEP(0xE1, 0, 0x03, 0x1D, 0x07, 0x06, 0x2E, 0x2C, 0x29, 0x2D, 0x2E, 0x2E, 0x37, 0x3F, 0x00,
              0x00, 0x02, 0x10),
    QTRI_STEP_ALONE(0x13, 10), /* the whole display, not a part */
    QTRI_STEP_ALONE(0x29, 10), /* display on */
};

/*
 * Address mode: rows reversed 0x80, columns reversed 0x40, exchanged 0x20, blue first 0x08. Glass
 * stands on its head on the chip.
 */
#define ST7735(glass_width, glass_height, across, down, column, row, is_inverted)                  \
    {                                                                                              \
        QTRI_MIPI(glass_width, glass_height, across, down, column, row, init),                     \
            .orientation = {0xC8, 0xA8, 0x08, 0x68}, .inverted = (is_inverted)                     \
    }

/* Pins of the module tell the chip how much memory it has: 128x160, 132x162 or 132x132. */
const qtri_panel_description qtri_st7735 = ST7735(128, 160, 128, 160, 0, 0, false);
const qtri_panel_description qtri_st7735_green = ST7735(128, 160, 132, 162, 2, 1, false);
const qtri_panel_description qtri_st7735_128x128 = ST7735(128, 128, 132, 132, 2, 1, false);
const qtri_panel_description qtri_st7735_80x160 = ST7735(80, 160, 132, 162, 26, 1, true);
const qtri_panel_description qtri_st7735_80x160_red = ST7735(80, 160, 128, 160, 24, 0, false);
