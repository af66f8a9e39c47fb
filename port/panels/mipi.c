/* SPDX-License-Identifier: MIT */
/* Addressing of TFT controllers with MIPI's command set: ILI9341, ST7789 and their like. */
#include "internal.h"

enum {
    SET_COLUMN_ADDRESS = 0x2A,
    SET_PAGE_ADDRESS = 0x2B,
    WRITE_MEMORY_START = 0x2C,
    ROWS_REVERSED = 0x80,
    COLUMNS_REVERSED = 0x40,
    EXCHANGED = 0x20
};

static enum qtri_error set_range(const qtri_panel *panel, uint8_t command, int32_t first,
                                 int32_t end)
{
    int32_t last = end - 1;
    uint8_t range[4] = {(uint8_t)(first >> 8), (uint8_t)first, (uint8_t)(last >> 8), (uint8_t)last};
    return qtri_panel_command(panel, command, range, 4);
}

/*
 * Addresses count in the frame's directions. Where the controller reverses an axis of its memory,
 * it counts from the other end, so the glass begins after what of the memory lies behind it.
 */
enum qtri_error qtri_panel_mipi_window(const qtri_panel *panel, const qtri_rect *window)
{
    const qtri_panel_description *d = panel->description;
    uint8_t orientation = panel->orientation;
    int32_t column = panel->column;
    int32_t row = panel->row;
    if ((orientation & COLUMNS_REVERSED) != 0) {
        column = d->memory_width - d->width - column;
    }
    if ((orientation & ROWS_REVERSED) != 0) {
        row = d->memory_height - d->height - row;
    }
    int32_t x = (orientation & EXCHANGED) != 0 ? row : column;
    int32_t y = (orientation & EXCHANGED) != 0 ? column : row;
    enum qtri_error error = set_range(panel, SET_COLUMN_ADDRESS, window->x0 + x, window->x1 + x);
    if (error == QTRI_OK) {
        error = set_range(panel, SET_PAGE_ADDRESS, window->y0 + y, window->y1 + y);
    }
    if (error == QTRI_OK) {
        error = qtri_panel_command(panel, WRITE_MEMORY_START, NULL, 0);
    }
    return error;
}
