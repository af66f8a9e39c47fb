/* SPDX-License-Identifier: MIT */
/* The simulated controllers, each on the glass of a module. */
#ifndef QTRI_HOST_PANELS_CONTROLLERS_H
#define QTRI_HOST_PANELS_CONTROLLERS_H

#include "oled.h"

/* SSD1306 (Solomon Systech, rev 1.1) on a glass of 128 x rows, 64 or 32, SEG127 left, last COM on
 * top. */
typedef struct ssd1306 {
    chip chip;
    int rows, first_column;
    uint8_t memory[8][128];
    int mode;
    oled_drive drive;
} ssd1306;
void ssd1306_init(ssd1306 *s, int rows);

/* On a glass of fewer columns, from SEG(127 - first_column) on, as many as it may be. */
void ssd1306_init_at(ssd1306 *s, int rows, int first_column);

/* SH1106 (Sino Wealth, V2.3) on a glass of 128x64 at SEG129 (left) down to SEG2, last COM on top.
 */
typedef struct sh1106 {
    chip chip;
    uint8_t memory[8][132];
    int column, page;
    oled_drive drive;
} sh1106;
void sh1106_init(sh1106 *s);

/*
 * SSD0323 (Solomon Systech, rev 1.0) on OSRAM's Pictiva glass of 128x64: SEG0 left, rows alternate
 * between the sides, the first row on top when COMs are remapped and offset by 76.
 */
typedef struct ssd0323 {
    chip chip;
    int first_row; /* of the memory that the first COM of the glass shows; 0 after init */
    uint8_t memory[80][64];
    int remap, offset, start_line, multiplex, mode;
    bool on;
} ssd0323;
void ssd0323_init(ssd0323 *s);

/* How a module's glass is connected to a TFT controller. */
typedef struct lcd_glass {
    int width, height, first_column, first_row;
    bool columns_from_right, blue_first, normally_black, rows_from_bottom;
} lcd_glass;

/* ILI9341 (ILI Technology, V1.11) and ST7789V (Sitronix, V1.0): MIPI's commands and some of their
 * own. */
typedef struct lcd {
    chip chip;
    lcd_glass glass;
    int width, height; /* of the memory in use */
    uint16_t memory[320][240];
    int address_mode, pixel_format, columns[2], pages[2];
    bool on, awake, inverted, half;
    uint8_t high;
    uint64_t wake_ms; /* from here on it may be woken */
} lcd;
void ili9341_init(lcd *s);
void st7789_init(lcd *s, const lcd_glass *glass);

/* ST7735R (Sitronix, V0.2), whose memory is 132x162 or, by its pins, less. */
void st7735_init(lcd *s, const lcd_glass *glass, int width, int height);

/* GC9A01 (GalaxyCore, V1.0) on a round glass of 240x240; its registers without a name are taken. */
void gc9a01_init(lcd *s, const lcd_glass *glass);

/* SSD1680 (Solomon Systech, rev 0.14) on a glass of 122x250, from source 8 and gate 0 on. */
typedef struct ssd1680 {
    chip chip;
    int width, height;           /* of the glass: 122, 250 after init */
    int first_column, first_row; /* of the glass in what is shown of the memory; 0 after init */
    uint8_t memory[296][22];
    uint8_t shown[296][22]; /* since the last refresh */
    uint8_t second[296][22];
    bool to_second; /* where data go */
    int gates, entry, x[2], y[2], counter_x, counter_y, update, options[2];
    bool counters_set;
    int refreshes, partial_refreshes;
} ssd1680;
void ssd1680_init(ssd1680 *s);

#endif
