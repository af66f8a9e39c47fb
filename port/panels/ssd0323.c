/* SPDX-License-Identifier: MIT */
#include "qtri_port/ssd0323.h"

#include "internal.h"

enum { SET_COLUMNS = 0x15, SET_ROWS = 0x75 };

static const qtri_panel_step init[] = {
    {0xAE, 0, {0}, 0},    /* display off */
    {0x81, 1, {50}, 0},   /* contrast, of 127 */
    {0x85, 0, {0}, 0},    /* half of the current range */
    {0xA0, 1, {0x52}, 0}, /* rows alternate between the sides, from the last; left pixel high */
    {0xA1, 1, {0}, 0},    /* start line */
    {0xA2, 1, {76}, 0},   /* offset: the glass has 64 of the chip's 80 rows */
    {0xA4, 0, {0}, 0},    /* show the memory */
    {0xA8, 1, {63}, 0},   /* rows - 1 */
    {0xB1, 1, {0x22}, 0}, /* phases: 2 and 2 clocks */
    {0xB2, 1, {70}, 0},   /* row period, clocks */
    {0xB3, 1, {0xF1}, 0}, /* fastest oscillator, divided by 2 */
    {0xBF, 1, {0x0D}, 0}, /* VSL */
    {0xBE, 1, {0x02}, 0}, /* VCOMH */
    {0xBC, 1, {0x10}, 0}, /* precharge voltage */
    {0xB8, 8, {0x01, 0x11, 0x22, 0x32, 0x43, 0x54, 0x65, 0x76}, 0}, /* gray levels, their widths */
    {0xAD, 1, {0x03}, 0},                                           /* DC-DC converter on */
    {0xAF, 0, {0}, 0},                                              /* display on */
};

/* Columns are bytes, two pixels. */
static enum qtri_error window(const qtri_panel *panel, const qtri_rect *bytes)
{
    uint8_t columns[2] = {(uint8_t)bytes->x0, (uint8_t)(bytes->x1 - 1)};
    uint8_t rows[2] = {(uint8_t)bytes->y0, (uint8_t)(bytes->y1 - 1)};
    enum qtri_error error = qtri_panel_command(panel, SET_COLUMNS, columns, 2);
    return error == QTRI_OK ? qtri_panel_command(panel, SET_ROWS, rows, 2) : error;
}

const qtri_panel_description qtri_ssd0323 = {
    .width = 128,
    .height = 64,
    .format = QTRI_PANEL_GRAY4,
    .init = init,
    .init_count = sizeof init / sizeof init[0],
    .reset_ms = 1,
    .start_ms = 1,
    .memory_width = 128,
    .memory_height = 80,
    .window = window,
};
