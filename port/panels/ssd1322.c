/* SPDX-License-Identifier: MIT */
#include "qtri_port/ssd1322.h"

#include "internal.h"

enum { WRITE_MEMORY = 0x5C };

static const qtri_panel_step init[] = {
    QTRI_STEP(0xFD, 0, 0x12),       /* commands unlocked */
    QTRI_STEP_ALONE(0xAE, 0),       /* display off */
    QTRI_STEP(0xB3, 0, 0x91),       /* oscillator 9, divided by 2 */
    QTRI_STEP(0xCA, 0, 63),         /* rows - 1 */
    QTRI_STEP(0xA2, 0, 0),          /* offset */
    QTRI_STEP(0xA1, 0, 0),          /* start line */
    QTRI_STEP(0xA0, 0, 0x14, 0x11), /* left pixel high, rows from the last COM; two COMs a row */
    QTRI_STEP(0xAB, 0, 0x01),       /* the regulator inside */
    QTRI_STEP(0xB4, 0, 0xA0, 0xFD), /* VSL from outside, better low levels */
    QTRI_STEP(0xC1, 0, 0x9F),       /* contrast */
    QTRI_STEP(0xC7, 0, 0x0F),       /* the whole current range */
    QTRI_STEP_ALONE(0xB9, 0),       /* gray levels in equal steps */
    QTRI_STEP(0xB1, 0, 0xE2),       /* phases: 5 and 14 clocks */
    QTRI_STEP(0xD1, 0, 0x82, 0x20), /* the reset value of what is reserved */
    QTRI_STEP(0xBB, 0, 0x1F),       /* precharge voltage: .6 VCC */
    QTRI_STEP(0xB6, 0, 0x08),       /* second precharge: 8 clocks */
    QTRI_STEP(0xBE, 0, 0x07),       /* VCOMH: .86 VCC */
    QTRI_STEP_ALONE(0xA9, 0),       /* the whole display, not a part */
    QTRI_STEP_ALONE(0xAF, 0),       /* display on */
};

/* Columns are two bytes, four pixels. */
static enum qtri_error window(const qtri_panel *panel, const qtri_rect *bytes)
{
    const int32_t x = panel->column / 4, y = panel->row;
    const qtri_rect range = {bytes->x0 / 2 + x, bytes->y0 + y, bytes->x1 / 2 + x, bytes->y1 + y};
    enum qtri_error error = qtri_panel_solomon_ranges(panel, &range);
    return error == QTRI_OK ? qtri_panel_command(panel, WRITE_MEMORY, NULL, 0) : error;
}

const qtri_panel_description qtri_ssd1322 = {
    .width = 256,
    .height = 64,
    .format = QTRI_PANEL_GRAY4,
    .init = init,
    .init_count = sizeof init / sizeof init[0],
    .parameters_are_data = true,
    .reset_ms = 1,
    .start_ms = 1,
    .memory_width = 480,
    .memory_height = 128,
    .first_column = 112, /* the glass is in the middle of 120 columns of four pixels */
    .window = window,
    .write = qtri_panel_write_gray,
    .window_mask = 1,
    .invert_commands = {0xA6, 0xA7},
};
