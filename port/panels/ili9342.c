/* SPDX-License-Identifier: MIT */
#include "qtri_port/ili9342.h"

#include "internal.h"

static const qtri_panel_step init[] = {
    QTRI_STEP_ALONE(0x01, 120),           /* software reset, for modules without the pin */
    QTRI_STEP(0xC8, 0, 0xFF, 0x93, 0x42), /* opens the commands below */
    QTRI_STEP(0xC0, 0, 0x12, 0x12),       /* voltages of the two gamma tables */
    QTRI_STEP(0xC1, 0, 0x03),             /* VGH and VGL */
    QTRI_STEP(0xC5, 0, 0xF2),             /* VCOM */
    QTRI_STEP(0xB0, 0, 0xE0),
    QTRI_STEP(0xF6, 0, 0x01, 0x00, 0x00),
    QTRI_STEP(0xB6, 0, 0x08, 0x82, 0x1D, 0x04), /* 240 lines */
    QTRI_STEP(0x3A, 0, 0x55),                   /* pixel format: 16 bits */
    QTRI_STEP(0xE0, 0, 0x00, 0x0C, 0x11, 0x04, 0x11, 0x08, 0x37, 0x89, 0x4C, 0x06, 0x0C, 0x0A, 0x2E,
              0x34, 0x0F), /* gamma for positive and negative voltages */
    QTRI_STEP(0xE1, 0, 0x00, 0x0B, 0x11, 0x05, 0x13, 0x09, 0x33, 0x67, 0x48, 0x07, 0x0E, 0x0B, 0x2E,
              0x33, 0x0F),
    QTRI_STEP_ALONE(0x11, 120), /* sleep out */
    QTRI_STEP_ALONE(0x29, 0),   /* display on */
};

/* Address mode: rows reversed 0x80, columns reversed 0x40, exchanged 0x20, blue first 0x08. */
const qtri_panel_description qtri_ili9342 = {QTRI_MIPI(320, 240, 320, 240, 0, 0, init),
                                             .orientation = {0x08, 0x68, 0xC8, 0xA8},
                                             .inverted = true};
