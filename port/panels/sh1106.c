/* SPDX-License-Identifier: MIT */
#include "qtri_port/sh1106.h"

#include "internal.h"

enum { SET_COLUMN_LOW = 0x00, SET_COLUMN_HIGH = 0x10, SET_PAGE = 0xB0 };

static const qtri_panel_step init[] = {
    QTRI_STEP_ALONE(0xAE, 0), /* display off */
    QTRI_STEP(0xD5, 0, 0x80), /* clock: divided by 1, oscillator at its middle */
    QTRI_STEP(0xA8, 0, 63),   /* rows - 1 */
    QTRI_STEP(0xD3, 0, 0),    /* display offset */
    QTRI_STEP_ALONE(0x40, 0), /* start line 0 */
    QTRI_STEP(0xAD, 0, 0x8B), /* DC-DC converter on when the display is */
    QTRI_STEP_ALONE(0x33, 0), /* its voltage: 9.0 */
    QTRI_STEP_ALONE(0xA1, 0), /* column 0 at SEG131, */
    QTRI_STEP_ALONE(0xC8, 0), /* row 0 at the last COM: modules are wired so */
    QTRI_STEP(0xDA, 0, 0x12), /* rows alternate between the halves of the COM pins */
    QTRI_STEP(0x81, 0, 0x80), /* contrast */
    QTRI_STEP(0xD9, 0, 0x1F), /* precharge: 15 and 1 clocks */
    QTRI_STEP(0xDB, 0, 0x40), /* VCOMH equals VREF */
    QTRI_STEP_ALONE(0xA4, 0), /* show the memory */
    QTRI_STEP_ALONE(0xAF, 0), /* display on */
};

/* One page: the column counts up, the page does not. */
static enum qtri_error window(const qtri_panel *panel, const qtri_rect *bytes)
{
    int32_t column = bytes->x0 + panel->column;
    int32_t page = bytes->y0 + panel->row / 8;
    const uint8_t commands[3] = {(uint8_t)(SET_PAGE | page),
                                 (uint8_t)(SET_COLUMN_HIGH | (column >> 4)),
                                 (uint8_t)(SET_COLUMN_LOW | (column & 15))};
    enum qtri_error error = QTRI_OK;
    for (int i = 0; i < 3 && error == QTRI_OK; i++) {
        error = qtri_panel_command(panel, commands[i], NULL, 0);
    }
    return error;
}

const qtri_panel_description qtri_sh1106 = {
    .width = 128,
    .height = 64,
    .format = QTRI_PANEL_GRAY1_PAGE,
    .init = init,
    .init_count = sizeof init / sizeof init[0],
    .reset_ms = 1,
    .start_ms = 100,
    .memory_width = 132,
    .memory_height = 64,
    .first_column = 2, /* the glass is at SEG2..SEG129 */
    .window = window,
    .write = qtri_panel_write_gray,
    .window_is_row = true,
    .invert_commands = {0xA6, 0xA7},
};
