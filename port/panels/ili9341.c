/* SPDX-License-Identifier: MIT */
#include "qtri_port/ili9341.h"

#include "internal.h"

/* What modules of 2.2 to 2.8 inch are driven with; reset values leave them paler. */
static const qtri_panel_step init[] = {
    QTRI_STEP_ALONE(0x01, 120), /* software reset, for modules without the pin; 120 ms in sleep */
    QTRI_STEP(0xCB, 0, 0x39, 0x2C, 0x00, 0x34, 0x02), /* core 1.6 V, DDVDH 5.6 V */
    QTRI_STEP(0xCF, 0, 0x00, 0xC1, 0x30),             /* equalising, protection against static */
    QTRI_STEP(0xE8, 0, 0x85, 0x00, 0x78),             /* timing of the gates, by the clock inside */
    QTRI_STEP(0xEA, 0, 0x00, 0x00),
    QTRI_STEP(0xED, 0, 0x64, 0x03, 0x12, 0x81), /* order in which the supplies start */
    QTRI_STEP(0xF7, 0, 0x20),                   /* charge pump: DDVDH twice VCI */
    QTRI_STEP(0xC0, 0, 0x23),                   /* GVDD 4.60 V */
    QTRI_STEP(0xC1, 0, 0x10),                   /* VGH 7 VCI, VGL -4 VCI */
    QTRI_STEP(0xC5, 0, 0x3E, 0x28),             /* VCOMH 4.25 V, VCOML -1.50 V, */
    QTRI_STEP(0xC7, 0, 0x86),                   /* both moved by -58 steps of their 128 */
    QTRI_STEP(0x3A, 0, 0x55),                   /* pixel format: 16 bits */
    QTRI_STEP(0xB1, 0, 0x00, 0x18),             /* 79 frames a second */
    QTRI_STEP(0xF2, 0, 0x00),                   /* one gamma curve for three colours, */
    QTRI_STEP(0x26, 0, 0x01),                   /* the first, */
    QTRI_STEP(0xE0, 0, 0x0F, 0x31, 0x2B, 0x0C, 0x0E, 0x08, 0x4E, 0xF1, 0x37, 0x07, 0x10, 0x03, 0x0E,
              0x09, 0x00), /* for positive voltages, */
    QTRI_STEP(0xE1, 0, 0x00, 0x0E, 0x14, 0x03, 0x11, 0x07, 0x31, 0xC1, 0x48, 0x08, 0x0F, 0x0C, 0x31,
              0x36, 0x0F),      /* and for negative ones */
    QTRI_STEP_ALONE(0x11, 120), /* sleep out: supplies and oscillator start */
    QTRI_STEP_ALONE(0x29, 0),   /* display on */
};

/* Address mode: rows reversed 0x80, columns reversed 0x40, exchanged 0x20, blue first 0x08. */
const qtri_panel_description qtri_ili9341 = {QTRI_MIPI(240, 320, 240, 320, 0, 0, init),
                                             .orientation = {0x48, 0x28, 0x88, 0xE8}};
