/* SPDX-License-Identifier: MIT */
#include "qtri_port/ssd1306.h"
#include "qtri_port/ssd1309.h"

#include "internal.h"

enum { SET_COLUMNS = 0x21, SET_PAGES = 0x22 };

/* Display off, the clock (0x80: divided by 1, the oscillator at its reset value), rows - 1, no
   offset, start line 0. */
#define SSD1306_BEGIN(rows, clock)                                                                 \
    QTRI_STEP_ALONE(0xAE, 0), QTRI_STEP(0xD5, 0, clock), QTRI_STEP(0xA8, 0, (rows)-1),             \
        QTRI_STEP(0xD3, 0, 0), QTRI_STEP_ALONE(0x40, 0)

#define CHARGE_PUMP_ON QTRI_STEP(0x8D, 0, 0x14)

/*
 * Horizontal addressing, column 0 at SEG127 and row 0 at the last COM: modules are wired so.
 * `pins`: how rows follow the COM pins, 0x02 in their order, 0x12 alternating between their halves;
 * then contrast, precharge (0xF1: 1 and 15 clocks, for the charge pump), VCOMH (0x20: .77 VCC), no
 * scrolling, show the memory, display on.
 */
#define SSD1306_END(pins, contrast, precharge, vcomh)                                              \
    QTRI_STEP(0x20, 0, 0x00), QTRI_STEP_ALONE(0xA1, 0), QTRI_STEP_ALONE(0xC8, 0),                  \
        QTRI_STEP(0xDA, 0, pins), QTRI_STEP(0x81, 0, contrast), QTRI_STEP(0xD9, 0, precharge),     \
        QTRI_STEP(0xDB, 0, vcomh), QTRI_STEP_ALONE(0x2E, 0), QTRI_STEP_ALONE(0xA4, 0),             \
        QTRI_STEP_ALONE(0xAF, 0)

static const qtri_panel_step init_64[] = {SSD1306_BEGIN(64, 0x80), CHARGE_PUMP_ON,
                                          SSD1306_END(0x12, 0xCF, 0xF1, 0x20)};
static const qtri_panel_step init_32[] = {SSD1306_BEGIN(32, 0x80), CHARGE_PUMP_ON,
                                          SSD1306_END(0x02, 0x8F, 0xF1, 0x20)};

/* Modules of 0.42 inch, whose reference current is the chip's own: 0xAD, of later revisions. */
static const qtri_panel_step init_40[] = {SSD1306_BEGIN(40, 0x80), QTRI_STEP(0xAD, 0, 0x30),
                                          CHARGE_PUMP_ON, SSD1306_END(0x12, 0xAF, 0x22, 0x20)};

/* The SSD1309 has no charge pump, and another scale of VCOMH: .78 VCC. */
static const qtri_panel_step init_1309[] = {SSD1306_BEGIN(64, 0xA0),
                                            SSD1306_END(0x12, 0x6F, 0xD3, 0x34)};

static enum qtri_error window(const qtri_panel *panel, const qtri_rect *bytes)
{
    int32_t x = panel->column;
    int32_t y = panel->row / 8;
    uint8_t columns[2] = {(uint8_t)(bytes->x0 + x), (uint8_t)(bytes->x1 - 1 + x)};
    uint8_t pages[2] = {(uint8_t)(bytes->y0 + y), (uint8_t)(bytes->y1 - 1 + y)};
    enum qtri_error error = qtri_panel_command(panel, SET_COLUMNS, columns, 2);
    return error == QTRI_OK ? qtri_panel_command(panel, SET_PAGES, pages, 2) : error;
}

/* Reset takes 3 us by the data sheet; slow modules want 100 ms until their supply stands. */
#define SSD1306(columns, rows, first, steps)                                                       \
    {                                                                                              \
        .width = (columns), .height = (rows), .format = QTRI_PANEL_GRAY1_PAGE, .init = (steps),    \
        .init_count = sizeof(steps) / sizeof(steps)[0], .reset_ms = 1, .start_ms = 100,            \
        .first_column = (first), .invert_commands = {0xA6, 0xA7}, .memory_width = 128,             \
        .memory_height = 64, .window = window, .write = qtri_panel_write_gray                      \
    }

const qtri_panel_description qtri_ssd1306 = SSD1306(128, 64, 0, init_64);
const qtri_panel_description qtri_ssd1306_128x32 = SSD1306(128, 32, 0, init_32);
const qtri_panel_description qtri_ssd1306_72x40 = SSD1306(72, 40, 28, init_40);
const qtri_panel_description qtri_ssd1309 = SSD1306(128, 64, 0, init_1309);
