/* SPDX-License-Identifier: MIT */
/* Addressing of Solomon Systech's OLED controllers with several bits a pixel. */
#include "internal.h"

enum { SET_COLUMNS = 0x15, SET_ROWS = 0x75 };

enum qtri_error qtri_panel_solomon_ranges(const qtri_panel *panel, const qtri_rect *range)
{
    const uint8_t columns[2] = {(uint8_t)range->x0, (uint8_t)(range->x1 - 1)};
    const uint8_t rows[2] = {(uint8_t)range->y0, (uint8_t)(range->y1 - 1)};
    enum qtri_error error = qtri_panel_command(panel, SET_COLUMNS, columns, 2);
    return error == QTRI_OK ? qtri_panel_command(panel, SET_ROWS, rows, 2) : error;
}

enum qtri_error qtri_panel_solomon_window(const qtri_panel *panel, const qtri_rect *bytes)
{
    const int32_t x = panel->column / 2, y = panel->row;
    const qtri_rect range = {bytes->x0 + x, bytes->y0 + y, bytes->x1 + x, bytes->y1 + y};
    return qtri_panel_solomon_ranges(panel, &range);
}
