/* SPDX-License-Identifier: MIT */
#include "qtri_port/ssd1327.h"

#include "internal.h"

static const qtri_panel_step init[] = {
    QTRI_STEP(0xFD, 0, 0x12), /* commands unlocked */
    QTRI_STEP_ALONE(0xAE, 0), /* display off */
    QTRI_STEP(0x81, 0, 0x80), /* contrast */
    QTRI_STEP(0xA0, 0,
              0x51),         /* column 0 at SEG127, left pixel high; COMs reversed, in two halves */
    QTRI_STEP(0xA1, 0, 0),   /* start line */
    QTRI_STEP(0xA2, 0, 0),   /* offset */
    QTRI_STEP(0xA8, 0, 127), /* rows - 1 */
    QTRI_STEP(0xAB, 0, 0x01), /* the regulator inside */
    QTRI_STEP(0xB1, 0, 0x11), /* phases: 1 and 1 clocks */
    QTRI_STEP(0xB3, 0, 0x00), /* clock: divided by 1 */
    QTRI_STEP(0xB6, 0, 0x04), /* second precharge: 4 clocks */
    QTRI_STEP(0xBC, 0, 0x08), /* precharge voltage: VCOMH */
    QTRI_STEP(0xBE, 0, 0x0F), /* VCOMH: .86 VCC */
    QTRI_STEP(0xD5, 0, 0x62), /* second precharge on, the reset value of what is reserved */
    QTRI_STEP_ALONE(0xB9, 0), /* gray levels in equal steps */
    QTRI_STEP_ALONE(0xAF, 0), /* display on */
};

const qtri_panel_description qtri_ssd1327 = {
    .width = 128,
    .height = 128,
    .format = QTRI_PANEL_GRAY4,
    .init = init,
    .init_count = sizeof init / sizeof init[0],
    .reset_ms = 1,
    .start_ms = 100,
    .memory_width = 128,
    .memory_height = 128,
    .window = qtri_panel_solomon_window,
    .write = qtri_panel_write_gray,
    .invert_commands = {0xA4, 0xA7},
};
