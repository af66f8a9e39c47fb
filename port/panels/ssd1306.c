/* SPDX-License-Identifier: MIT */
#include "qtri_port/ssd1306.h"

#include "internal.h"

enum { SET_COLUMNS = 0x21, SET_PAGES = 0x22 };

static const qtri_panel_step init_64[] = {
    {0xAE, 0, {0}, 0},    /* display off */
    {0xD5, 1, {0x80}, 0}, /* clock: divided by 1, oscillator at its reset value */
    {0xA8, 1, {63}, 0},   /* rows - 1 */
    {0xD3, 1, {0}, 0},    /* display offset */
    {0x40, 0, {0}, 0},    /* start line 0 */
    {0x8D, 1, {0x14}, 0}, /* charge pump on */
    {0x20, 1, {0x00}, 0}, /* horizontal addressing */
    {0xA1, 0, {0}, 0},    /* column 0 at SEG127, */
    {0xC8, 0, {0}, 0},    /* row 0 at the last COM: modules are wired so */
    {0xDA, 1, {0x12}, 0}, /* rows alternate between the halves of the COM pins */
    {0x81, 1, {0xCF}, 0}, /* contrast */
    {0xD9, 1, {0xF1}, 0}, /* precharge: 1 and 15 clocks, for the charge pump */
    {0xDB, 1, {0x20}, 0}, /* VCOMH .77 VCC */
    {0x2E, 0, {0}, 0},    /* no scrolling */
    {0xA4, 0, {0}, 0},    /* show the memory */
    {0xA6, 0, {0}, 0},    /* 1 is lit */
    {0xAF, 0, {0}, 0},    /* display on */
};

static const qtri_panel_step init_32[] = {
    {0xAE, 0, {0}, 0},    /* display off */
    {0xD5, 1, {0x80}, 0}, /* clock: divided by 1, oscillator at its reset value */
    {0xA8, 1, {31}, 0},   /* rows - 1 */
    {0xD3, 1, {0}, 0},    /* display offset */
    {0x40, 0, {0}, 0},    /* start line 0 */
    {0x8D, 1, {0x14}, 0}, /* charge pump on */
    {0x20, 1, {0x00}, 0}, /* horizontal addressing */
    {0xA1, 0, {0}, 0},    /* column 0 at SEG127, */
    {0xC8, 0, {0}, 0},    /* row 0 at the last COM: modules are wired so */
    {0xDA, 1, {0x02}, 0}, /* rows follow the COM pins */
    {0x81, 1, {0x8F}, 0}, /* contrast */
    {0xD9, 1, {0xF1}, 0}, /* precharge: 1 and 15 clocks, for the charge pump */
    {0xDB, 1, {0x20}, 0}, /* VCOMH .77 VCC */
    {0x2E, 0, {0}, 0},    /* no scrolling */
    {0xA4, 0, {0}, 0},    /* show the memory */
    {0xA6, 0, {0}, 0},    /* 1 is lit */
    {0xAF, 0, {0}, 0},    /* display on */
};

static enum qtri_error window(const qtri_panel *panel, const qtri_rect *bytes)
{
    uint8_t columns[2] = {(uint8_t)bytes->x0, (uint8_t)(bytes->x1 - 1)};
    uint8_t pages[2] = {(uint8_t)bytes->y0, (uint8_t)(bytes->y1 - 1)};
    enum qtri_error error = qtri_panel_command(panel, SET_COLUMNS, columns, 2);
    return error == QTRI_OK ? qtri_panel_command(panel, SET_PAGES, pages, 2) : error;
}

#define SSD1306(rows, steps)                                                                       \
    {                                                                                              \
        .width = 128, .height = (rows), .format = QTRI_PANEL_GRAY1_PAGE, .init = (steps),          \
        .init_count = sizeof(steps) / sizeof(steps)[0], .reset_ms = 1 /* 3 us */, .start_ms = 1,   \
        .memory_width = 128, .memory_height = 64, .window = window                                 \
    }

const qtri_panel_description qtri_ssd1306 = SSD1306(64, init_64);
const qtri_panel_description qtri_ssd1306_128x32 = SSD1306(32, init_32);
