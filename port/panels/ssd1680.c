/* SPDX-License-Identifier: MIT */
#include "qtri_port/ssd1680.h"

#include "internal.h"

enum {
    SET_X_RANGE = 0x44,
    SET_Y_RANGE = 0x45,
    SET_X_COUNTER = 0x4E,
    SET_Y_COUNTER = 0x4F,
    WRITE_MEMORY = 0x24,
    WRITE_SECOND_MEMORY = 0x26
};

static const qtri_panel_step init[] = {
    QTRI_STEP_ALONE(0x12, QTRI_STEP_UNTIL_READY), /* software reset */
    QTRI_STEP(0x01, 0, 249, 0, 0x00),             /* gates: 250 rows, from the first, in order */
    QTRI_STEP(0x11, 0, 0x03),                     /* addresses count up, along a row first */
    QTRI_STEP(0x3C, 0, 0x05),                     /* the border follows the white waveform */
    QTRI_STEP(0x18, 0, 0x80),                     /* the temperature sensor inside */
    QTRI_STEP(0x21, 0, 0x40, 0x80), /* memory of the second colour as 0; sources 8..167 */
};

static const qtri_panel_step refresh[] = {
    QTRI_STEP(0x22, 0, 0xF7), /* clock, supplies, temperature, waveform 1, all off */
    QTRI_STEP_ALONE(0x20, QTRI_STEP_UNTIL_READY), /* do so */
};

/* Waveform 2 moves pixels that differ between the memory and that of the second colour alone. */
static const qtri_panel_step refresh_changes[] = {
    QTRI_STEP(0x3C, 0, 0x80),       /* the border stays as it is */
    QTRI_STEP(0x21, 0, 0x00, 0x80), /* the second memory counts */
    QTRI_STEP(0x22, 0, 0xFF),       /* clock, supplies, temperature, waveform 2, all off */
    QTRI_STEP_ALONE(0x20, QTRI_STEP_UNTIL_READY),
    QTRI_STEP(0x21, 0, 0x40, 0x80), /* back to what a refresh of everything wants */
    QTRI_STEP(0x3C, 0, 0x05),
};

/* Across in bytes of eight pixels. The counters begin where the window does. */
static enum qtri_error open_window(const qtri_panel *panel, const qtri_rect *bytes, uint8_t write)
{
    int32_t column = panel->column / 8;
    int32_t y0 = bytes->y0 + panel->row;
    int32_t y1 = bytes->y1 - 1 + panel->row;
    uint8_t x[2] = {(uint8_t)(bytes->x0 + column), (uint8_t)(bytes->x1 - 1 + column)};
    uint8_t y[4] = {(uint8_t)y0, (uint8_t)(y0 >> 8), (uint8_t)y1, (uint8_t)(y1 >> 8)};
    const struct {
        uint8_t command, count;
        const uint8_t *parameters;
    } steps[] = {{SET_X_RANGE, 2, x},
                 {SET_Y_RANGE, 4, y},
                 {SET_X_COUNTER, 1, x},
                 {SET_Y_COUNTER, 2, y},
                 {write, 0, NULL}};
    enum qtri_error error = QTRI_OK;
    for (size_t i = 0; i < sizeof steps / sizeof steps[0] && error == QTRI_OK; i++) {
        error = qtri_panel_command(panel, steps[i].command, steps[i].parameters, steps[i].count);
    }
    return error;
}

static enum qtri_error window(const qtri_panel *panel, const qtri_rect *bytes)
{
    return open_window(panel, bytes, WRITE_MEMORY);
}

/* The panel's memory is an image of what was sent. */
static enum qtri_error shown(qtri_panel *panel)
{
    const qtri_panel_description *d = panel->description;
    const size_t row_bytes = QTRI_PANEL_ROW_BYTES(d->width, d->format);
    const qtri_rect all = {0, 0, (int32_t)row_bytes, d->height};
    enum qtri_error error = open_window(panel, &all, WRITE_SECOND_MEMORY);
    return error == QTRI_OK ? qtri_panel_data(panel, panel->memory, row_bytes * d->height) : error;
}

static const qtri_panel_partial partial = {
    refresh_changes, sizeof refresh_changes / sizeof refresh_changes[0], shown};

/* A full refresh takes 2 s, more in the cold. */
#define SSD1680(changes)                                                                           \
    {                                                                                              \
        .width = 122, .height = 250, .format = QTRI_PANEL_GRAY1, .init = init,                     \
        .init_count = sizeof init / sizeof init[0], .refresh = refresh,                            \
        .refresh_count = sizeof refresh / sizeof refresh[0], .parameters_are_data = true,          \
        .reset_ms = 10, .start_ms = 10, .busy_ms = 10000, .blind_ms = 2000, .memory_width = 176,   \
        .memory_height = 296, .window = window, .partial = (changes)                               \
    }

const qtri_panel_description qtri_ssd1680 = SSD1680(NULL);
const qtri_panel_description qtri_ssd1680_partial = SSD1680(&partial);
