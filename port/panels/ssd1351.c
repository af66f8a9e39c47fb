/* SPDX-License-Identifier: MIT */
#include "qtri_port/ssd1351.h"

#include "internal.h"

enum {
    WRITE_MEMORY = 0x5C,
    DOWN_FIRST = 0x01,
    COLUMNS_BIT = 0x02,
    RED_BLUE_BIT = 0x04,
    ROWS_BIT = 0x10
};

static const qtri_panel_step init[] = {
    QTRI_STEP(0xFD, 0, 0x12),             /* commands unlocked, */
    QTRI_STEP(0xFD, 0, 0xB1),             /* all of them */
    QTRI_STEP_ALONE(0xAE, 0),             /* display off */
    QTRI_STEP(0xB3, 0, 0xF1),             /* fastest oscillator, divided by 2 */
    QTRI_STEP(0xCA, 0, 127),              /* rows - 1 */
    QTRI_STEP(0xA1, 0, 0),                /* start line */
    QTRI_STEP(0xA2, 0, 0),                /* offset */
    QTRI_STEP(0xB5, 0, 0x00),             /* pins of its own are off */
    QTRI_STEP(0xAB, 0, 0x01),             /* the regulator inside */
    QTRI_STEP(0xB1, 0, 0x32),             /* phases: 5 and 3 clocks */
    QTRI_STEP(0xBE, 0, 0x05),             /* VCOMH: .82 VCC */
    QTRI_STEP(0xC1, 0, 0xC8, 0x80, 0xC8), /* contrast of the three colours */
    QTRI_STEP(0xC7, 0, 0x0F),             /* the whole current range */
    QTRI_STEP(0xB4, 0, 0xA0, 0xB5, 0x55), /* VSL from outside */
    QTRI_STEP(0xB6, 0, 0x01),             /* second precharge: 1 clock */
    QTRI_STEP_ALONE(0xAF, 0),             /* display on */
};

/*
 * Addresses count in the frame's directions, as the memory's columns and rows: where the frame's
 * rows go down the glass's columns, the row counts first.
 */
static enum qtri_error window(const qtri_panel *panel, const qtri_rect *rect)
{
    const bool is_turned = (panel->orientation & DOWN_FIRST) != 0;
    const qtri_rect turned = {rect->y0, rect->x0, rect->y1, rect->x1};
    enum qtri_error error = qtri_panel_solomon_ranges(panel, is_turned ? &turned : rect);
    return error == QTRI_OK ? qtri_panel_command(panel, WRITE_MEMORY, NULL, 0) : error;
}

/* Address mode: 16 bits a pixel 0x40, COMs in two halves 0x20, and the bits above. */
const qtri_panel_description qtri_ssd1351 = {
    .width = 128,
    .height = 128,
    .format = QTRI_PANEL_RGB565,
    .order = QTRI_ORDER_BIG,
    .init = init,
    .init_count = sizeof init / sizeof init[0],
    .parameters_are_data = true,
    .reset_ms = 1,
    .start_ms = 100,
    .orientation_command = 0xA0,
    .orientation = {0x74, 0x77, 0x66, 0x65},
    .rows_bit = ROWS_BIT,
    .columns_bit = COLUMNS_BIT,
    .red_blue_bit = RED_BLUE_BIT,
    .memory_width = 128,
    .memory_height = 128,
    .window = window,
    .write = qtri_panel_write_565,
    .invert_commands = {0xA6, 0xA7},
};
