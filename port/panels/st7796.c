/* SPDX-License-Identifier: MIT */
#include "qtri_port/st7796.h"

#include "internal.h"

static const qtri_panel_step init[] = {
    QTRI_STEP_ALONE(0x01, 120), /* software reset, for modules without the pin */
    QTRI_STEP_ALONE(0x11, 120), /* sleep out */
    QTRI_STEP(0xF0, 0, 0xC3),   /* opens the commands below */
    QTRI_STEP(0xF0, 0, 0x96),
    QTRI_STEP(0x3A, 0, 0x55),             /* pixel format: 16 bits */
    QTRI_STEP(0xB4, 0, 0x01),             /* neighbours of opposite polarity */
    QTRI_STEP(0xB6, 0, 0x80, 0x02, 0x3B), /* 480 lines, from the memory */
    QTRI_STEP(0xE8, 0, 0x40, 0x8A, 0x00, 0x00, 0x29, 0x19, 0xA5, 0x33), /* timing of gates */
    QTRI_STEP(0xC1, 0, 0x06),                                           /* VGH and VGL */
    QTRI_STEP(0xC2, 0, 0xA7), /* current of the source drivers */
    QTRI_STEP(0xC5, 0, 0x18), /* VCOM .9 V */
    QTRI_STEP(0xE0, 0, 0xF0, 0x09, 0x0B, 0x06, 0x04, 0x15, 0x2F, 0x54, 0x42, 0x3C, 0x17, 0x14, 0x18,
              0x1B), /* gamma for positive and negative voltages */
    QTRI_STEP(0xE1, 0, 0xE0, 0x09, 0x0B, 0x06, 0x04, 0x03, 0x2B, 0x43, 0x42, 0x3B, 0x16, 0x14, 0x17,
              0x1B),
    QTRI_STEP(0xF0, 0, 0x3C), /* closes them */
    QTRI_STEP(0xF0, 0, 0x69),
    QTRI_STEP_ALONE(0x29, 10), /* display on */
};

/* Address mode: rows reversed 0x80, columns reversed 0x40, exchanged 0x20, blue first 0x08. */
const qtri_panel_description qtri_st7796 = {QTRI_MIPI(320, 480, 320, 480, 0, 0, init),
                                            .orientation = {0x48, 0x28, 0x88, 0xE8}};
