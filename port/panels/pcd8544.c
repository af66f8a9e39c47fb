/* SPDX-License-Identifier: MIT */
#include "qtri_port/pcd8544.h"

#include "internal.h"

enum { SET_PAGE = 0x40, SET_COLUMN = 0x80 };

/* Bits of the function set 0x20: extended instructions 0x01, powered down 0x04. */
static const qtri_panel_step init[] = {
    QTRI_STEP_ALONE(0x25, 0), /* extended instructions, asleep */
    QTRI_STEP_ALONE(0xB8, 0), /* VOP 0x38: 6.4 V, the contrast */
    QTRI_STEP_ALONE(0x06, 0), /* temperature coefficient 2 */
    QTRI_STEP_ALONE(0x13, 0), /* bias 1:48, for 48 rows */
    QTRI_STEP_ALONE(0x24, 0), /* the others, along a page */
    QTRI_STEP_ALONE(0x20, 0), /* awake: display on */
};

/* One page: the column counts up. */
static enum qtri_error window(const qtri_panel *panel, const qtri_rect *bytes)
{
    enum qtri_error error = qtri_panel_command(panel, (uint8_t)(SET_PAGE | bytes->y0), NULL, 0);
    return error == QTRI_OK ? qtri_panel_command(panel, (uint8_t)(SET_COLUMN | bytes->x0), NULL, 0)
                            : error;
}

/* A bit darkens a pixel, unless the display is inverse. */
const qtri_panel_description qtri_pcd8544 = {
    .width = 84,
    .height = 48,
    .format = QTRI_PANEL_GRAY1_PAGE,
    .init = init,
    .init_count = sizeof init / sizeof init[0],
    .reset_ms = 1,
    .start_ms = 1,
    .memory_width = 84,
    .memory_height = 48,
    .window = window,
    .write = qtri_panel_write_gray,
    .window_is_row = true,
    .inverted = true,
    .invert_commands = {0x0C, 0x0D},
};
