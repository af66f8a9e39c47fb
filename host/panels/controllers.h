/* SPDX-License-Identifier: MIT */
/* The simulated controllers, each on the glass of a module. */
#ifndef QTRI_HOST_PANELS_CONTROLLERS_H
#define QTRI_HOST_PANELS_CONTROLLERS_H

#include "oled.h"

/* How a module's glass is connected to a controller of colours. */
typedef struct lcd_glass {
    int width, height, first_column, first_row;
    bool columns_from_right, blue_first, normally_black, rows_from_bottom;
} lcd_glass;

/* A channel of 0..max as one of 0..255, and the colour that a glass shows of three such. */
uint32_t lcd_widened(uint32_t value, uint32_t max);
uint32_t lcd_glass_shows(const lcd_glass *glass, uint32_t first, uint32_t green, uint32_t last,
                         bool swapped, bool inverted);

/* SSD1306 (Solomon Systech, rev 1.1) on a glass of 128 x rows, 64 or 32, SEG127 left, last COM on
 * top. */
typedef struct ssd1306 {
    chip chip;
    int rows, first_column;
    bool has_pump; /* false: an SSD1309 */
    uint8_t memory[8][128];
    int mode;
    oled_drive drive;
} ssd1306;
void ssd1306_init(ssd1306 *s, int rows);

/* On a glass of fewer columns, from SEG(127 - first_column) on, as many as it may be. */
void ssd1306_init_at(ssd1306 *s, int rows, int first_column);

/* SSD1309 (Solomon Systech, rev 1.1): no charge pump, another scale of VCOMH. 128x64. */
void ssd1309_init(ssd1306 *s);

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
 * Solomon Systech's controllers of OLEDs of 16 grays: SSD0323 (rev 1.0) on OSRAM's Pictiva glass of
 * 128x64, SSD1327 (rev 1.0) on 128x128, SSD1322 (rev 1.2) on 256x64. Each glass shows its first row
 * on top when COMs are reversed and offset as its modules are wired.
 */
struct gray_kind;
typedef struct ssd0323 {
    chip chip;
    const struct gray_kind *kind;
    int first_row; /* of the memory that the first COM of the glass shows; 0 after init */
    uint8_t memory[128][240];
    int remap, offset, start_line, multiplex, mode, second;
    bool on;
} ssd0323;
void ssd0323_init(ssd0323 *s);
void ssd1327_init(ssd0323 *s);
void ssd1322_init(ssd0323 *s);

/* SSD1351 (Solomon Systech, rev 1.5) on a colour glass of 128x128, SEG0 left, last COM on top. */
typedef struct ssd1351 {
    chip chip;
    lcd_glass glass;
    uint16_t memory[128][128];
    int remap, unlocked, ranges[2][2];
    bool on, inverse, half;
    uint8_t high;
} ssd1351;
void ssd1351_init(ssd1351 *s, const lcd_glass *glass);

/* PCD8544 (Philips, 1999) on the glass of 84x48. */
typedef struct pcd8544 {
    chip chip;
    uint8_t memory[6][84];
    int function, display, vop, bias;
} pcd8544;
void pcd8544_init(pcd8544 *s);

/* A memory LCD of Sharp's: D/C is SCS. */
typedef struct sharp_lcd {
    chip chip;
    int width, height;
    uint8_t memory[240][50], latch[50];
    int state, line, have;
    bool dirty; /* a line that nothing followed yet */
    int vcom, vcom_changes;
} sharp_lcd;
void sharp_init(sharp_lcd *s, int width, int height);

/* UC8151D (UltraChip, rev 0.1) on e-paper of 128x296. */
typedef struct uc8151 {
    chip chip;
    uint8_t memory[296][16], shown[296][16];
    int panel, resolution[2], interval, range[2][2];
    bool powered, partial;
    int refreshes;
} uc8151;
void uc8151_init(uc8151 *s);

/* ILI9341 (ILI Technology, V1.11) and ST7789V (Sitronix, V1.0): MIPI's commands and some of their
 * own. */
typedef struct lcd {
    chip chip;
    lcd_glass glass;
    int width, height;         /* of the memory in use */
    uint32_t memory[480][320]; /* 16 bits, or three bytes of six bits, the high ones */
    int address_mode, pixel_format, columns[2], pages[2];
    bool on, awake, inverted;
    bool locked, extended; /* the manufacturer's commands must be opened; they are */
    int opened;
    int bytes, have; /* of a pixel; those that have arrived */
    uint32_t part;
    uint64_t wake_ms; /* from here on it may be woken */
} lcd;
void ili9341_init(lcd *s);

/* ILI9342C (320x240), ILI9488 (320x480, 18 bits a pixel), ST7796S (320x480). */
void ili9342_init(lcd *s, const lcd_glass *glass);
void ili9488_init(lcd *s, const lcd_glass *glass);
void st7796_init(lcd *s, const lcd_glass *glass);

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
    int last_x, last_y;          /* of the memory: bytes, rows */
    int sources;                 /* the byte that says how the glass is wired */
    uint8_t memory[296][25];
    uint8_t shown[296][25]; /* since the last refresh */
    uint8_t second[296][25];
    bool to_second; /* where data go */
    int gates, entry, x[2], y[2], counter_x, counter_y, update, options[2];
    bool counters_set;
    int refreshes, partial_refreshes;
} ssd1680;
void ssd1680_init(ssd1680 *s);

/* SSD1681 (Solomon Systech, rev 1.0) on a glass of 200x200. */
void ssd1681_init(ssd1680 *s);

#endif
