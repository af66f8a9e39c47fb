/* SPDX-License-Identifier: MIT */
#include "qtri_port/ssd0323.h"

#include "internal.h"

static const qtri_panel_step init[] = {
    QTRI_STEP_ALONE(0xAE, 0), /* display off */
    QTRI_STEP(0x81, 0, 50),   /* contrast, of 127 */
    QTRI_STEP_ALONE(0x85, 0), /* half of the current range */
    QTRI_STEP(0xA0, 0, 0x52), /* rows alternate between the sides, from the last; left pixel high */
    QTRI_STEP(0xA1, 0, 0),    /* start line */
    QTRI_STEP(0xA2, 0, 76),   /* offset: the glass has 64 of the chip's 80 rows */
    QTRI_STEP(0xA8, 0, 63),   /* rows - 1 */
    QTRI_STEP(0xB1, 0, 0x22), /* phases: 2 and 2 clocks */
    QTRI_STEP(0xB2, 0, 70),   /* row period, clocks */
    QTRI_STEP(0xB3, 0, 0xF1), /* fastest oscillator, divided by 2 */
    QTRI_STEP(0xBF, 0, 0x0D), /* VSL */
    QTRI_STEP(0xBE, 0, 0x02), /* VCOMH */
    QTRI_STEP(0xBC, 0, 0x10), /* precharge voltage */
    QTRI_STEP(0xB8, 0, 0x01, 0x11, 0x22, 0x32, 0x43, 0x54, 0x65,
              0x76),          /* gray levels, their widths */
    QTRI_STEP(0xAD, 0, 0x03), /* DC-DC converter on */
    QTRI_STEP_ALONE(0xAF, 0), /* display on */
};

const qtri_panel_description qtri_ssd0323 = {
    .width = 128,
    .height = 64,
    .format = QTRI_PANEL_GRAY4,
    .init = init,
    .init_count = sizeof init / sizeof init[0],
    .reset_ms = 1,
    .start_ms = 1,
    .memory_width = 128,
    .memory_height = 80,
    .window = qtri_panel_solomon_window,
    .write = qtri_panel_write_gray,
    .invert_commands = {0xA4, 0xA7},
};
