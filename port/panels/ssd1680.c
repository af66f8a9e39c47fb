/* SPDX-License-Identifier: MIT */
#include "qtri_port/ssd1680.h"
#include "qtri_port/ssd1681.h"

#include "internal.h"

enum {
    SET_X_RANGE = 0x44,
    SET_Y_RANGE = 0x45,
    SET_X_COUNTER = 0x4E,
    SET_Y_COUNTER = 0x4F,
    WRITE_MEMORY = 0x24,
    WRITE_SECOND_MEMORY = 0x26
};

/*
 * Software reset; gates: so many rows, from the first, in order; addresses count up, along a row
 * first; the border follows the white waveform; the temperature sensor inside; the memory of the
 * second colour counts as 0. sources: 0x80, of the SSD1680, is 8..167 of its 176.
 */
#define INIT(rows, sources)                                                                        \
    QTRI_STEP_ALONE(0x12, QTRI_STEP_UNTIL_READY), QTRI_STEP(0x01, 0, (rows)-1, 0, 0x00),           \
        QTRI_STEP(0x11, 0, 0x03), QTRI_STEP(0x3C, 0, 0x05), QTRI_STEP(0x18, 0, 0x80),              \
        QTRI_STEP(0x21, 0, 0x40, sources)

static const qtri_panel_step init[] = {INIT(250, 0x80)};
static const qtri_panel_step init_1681[] = {INIT(200, 0x00)};

static const qtri_panel_step refresh[] = {
    QTRI_STEP(0x22, 0, 0xF7), /* clock, supplies, temperature, waveform 1, all off */
    QTRI_STEP_ALONE(0x20, QTRI_STEP_UNTIL_READY), /* do so */
};

/*
 * Waveform 2 moves pixels that differ between the memory and that of the second colour alone: the
 * border stays as it is, the second memory counts; clock, supplies, temperature, waveform 2, all
 * off; then back to what a refresh of everything wants.
 */
#define REFRESH_CHANGES(sources)                                                                   \
    QTRI_STEP(0x3C, 0, 0x80), QTRI_STEP(0x21, 0, 0x00, sources), QTRI_STEP(0x22, 0, 0xFF),         \
        QTRI_STEP_ALONE(0x20, QTRI_STEP_UNTIL_READY), QTRI_STEP(0x21, 0, 0x40, sources),           \
        QTRI_STEP(0x3C, 0, 0x05)

static const qtri_panel_step refresh_changes[] = {REFRESH_CHANGES(0x80)};
static const qtri_panel_step refresh_changes_1681[] = {REFRESH_CHANGES(0x00)};

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
static const qtri_panel_partial partial_1681 = {
    refresh_changes_1681, sizeof refresh_changes_1681 / sizeof refresh_changes_1681[0], shown};

/* A full refresh takes 2 s, more in the cold. */
#define SSD168X(glass_width, glass_height, memory_w, memory_h, steps, changes)                     \
    {                                                                                              \
        .width = (glass_width), .height = (glass_height), .format = QTRI_PANEL_GRAY1,              \
        .init = (steps), .init_count = sizeof(steps) / sizeof(steps)[0], .refresh = refresh,       \
        .refresh_count = sizeof refresh / sizeof refresh[0], .parameters_are_data = true,          \
        .reset_ms = 10, .start_ms = 10, .busy_ms = 10000, .blind_ms = 2000,                        \
        .memory_width = (memory_w), .memory_height = (memory_h), .window = window,                 \
        .write = qtri_panel_write_gray, .partial = (changes)                                       \
    }

const qtri_panel_description qtri_ssd1680 = SSD168X(122, 250, 176, 296, init, NULL);
const qtri_panel_description qtri_ssd1680_partial = SSD168X(122, 250, 176, 296, init, &partial);
const qtri_panel_description qtri_ssd1681 = SSD168X(200, 200, 200, 200, init_1681, NULL);
const qtri_panel_description qtri_ssd1681_partial =
    SSD168X(200, 200, 200, 200, init_1681, &partial_1681);
