/* SPDX-License-Identifier: MIT */
/* The simulated controllers, each on the glass of a module. */
#ifndef QTRI_HOST_PANELS_CONTROLLERS_H
#define QTRI_HOST_PANELS_CONTROLLERS_H

#include "chip.h"

/* SSD1306 (Solomon Systech, rev 1.1) on a glass of 128 x rows, 64 or 32, SEG127 left, last COM on
 * top. */
typedef struct ssd1306 {
    chip chip;
    int rows;
    uint8_t memory[8][128];
    int mode, multiplex, offset, start_line, pins;
    bool columns_reversed, rows_reversed, inverse, all_on, on, pump;
} ssd1306;
void ssd1306_init(ssd1306 *s, int rows);

/*
 * SSD0323 (Solomon Systech, rev 1.0) on OSRAM's Pictiva glass of 128x64: SEG0 left, rows alternate
 * between the sides, the first row on top when COMs are remapped and offset by 76.
 */
typedef struct ssd0323 {
    chip chip;
    uint8_t memory[80][64];
    int remap, offset, start_line, multiplex, mode;
    bool on;
} ssd0323;
void ssd0323_init(ssd0323 *s);

/* How a module's glass is connected to a TFT controller with 240 columns and 320 rows. */
typedef struct lcd_glass {
    int width, height, first_column, first_row;
    bool columns_from_right, blue_first, normally_black;
} lcd_glass;

/* ILI9341 (ILI Technology, V1.11) and ST7789V (Sitronix, V1.0): MIPI's commands and some of their
 * own. */
typedef struct lcd {
    chip chip;
    lcd_glass glass;
    uint16_t memory[320][240];
    int address_mode, pixel_format, columns[2], pages[2];
    bool on, awake, inverted, half;
    uint8_t high;
    uint64_t wake_ms; /* from here on it may be woken */
} lcd;
void ili9341_init(lcd *s);
void st7789_init(lcd *s, const lcd_glass *glass);

/* SSD1680 (Solomon Systech, rev 0.14) on a glass of 122x250 at sources 8..129 and gates 0..249. */
typedef struct ssd1680 {
    chip chip;
    uint8_t memory[296][22];
    uint8_t shown[296][22]; /* since the last refresh */
    int gates, entry, x[2], y[2], counter_x, counter_y, update, options[2];
    bool counters_set;
    int refreshes;
} ssd1680;
void ssd1680_init(ssd1680 *s);

#endif
