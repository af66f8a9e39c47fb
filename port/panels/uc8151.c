/* SPDX-License-Identifier: MIT */
#include "qtri_port/uc8151.h"

#include "internal.h"

enum { WRITE_NEW = 0x13, PARTIAL_WINDOW = 0x90, PARTIAL_IN = 0x91 };

/* Voltages, soft start of the booster, frame rate: reset values. */
static const qtri_panel_step init[] = {
    QTRI_STEP(0x00, QTRI_STEP_UNTIL_READY, 0x9F), /* 128x296, black and white, waveforms in OTP */
    QTRI_STEP(0x61, 0, 128, 0x01, 0x28),          /* 128 columns, 296 rows */
    QTRI_STEP(0x50, 0, 0x97),                     /* 1 is white, the border too */
};

static const qtri_panel_step refresh[] = {
    QTRI_STEP_ALONE(0x92, 0),                     /* the whole display, not a part */
    QTRI_STEP_ALONE(0x04, QTRI_STEP_UNTIL_READY), /* power on */
    QTRI_STEP_ALONE(0x12, QTRI_STEP_UNTIL_READY), /* show the memory */
    QTRI_STEP_ALONE(0x02, QTRI_STEP_UNTIL_READY), /* power off */
};

/* Columns are given as pixels, eight a byte: the last one is that of its byte. */
static enum qtri_error window(const qtri_panel *panel, const qtri_rect *bytes)
{
    const int32_t x0 = bytes->x0 * 8 + panel->column, x1 = bytes->x1 * 8 + panel->column - 1;
    const int32_t y0 = bytes->y0 + panel->row, y1 = bytes->y1 - 1 + panel->row;
    const uint8_t range[7] = {(uint8_t)x0, (uint8_t)x1,        (uint8_t)(y0 >> 8),
                              (uint8_t)y0, (uint8_t)(y1 >> 8), (uint8_t)y1,
                              0x01};
    enum qtri_error error = qtri_panel_command(panel, PARTIAL_IN, NULL, 0);
    error = error == QTRI_OK ? qtri_panel_command(panel, PARTIAL_WINDOW, range, 7) : error;
    return error == QTRI_OK ? qtri_panel_command(panel, WRITE_NEW, NULL, 0) : error;
}

const qtri_panel_description qtri_uc8151 = {
    .width = 128,
    .height = 296,
    .format = QTRI_PANEL_GRAY1,
    .init = init,
    .init_count = sizeof init / sizeof init[0],
    .refresh = refresh,
    .refresh_count = sizeof refresh / sizeof refresh[0],
    .parameters_are_data = true,
    .reset_ms = 10,
    .start_ms = 10,
    .busy_ms = 15000,
    .blind_ms = 5000,
    .memory_width = 128,
    .memory_height = 296,
    .window = window,
    .write = qtri_panel_write_gray,
};
