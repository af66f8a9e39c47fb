/* SPDX-License-Identifier: MIT */
/*
 * What the tests of panels share: a bus that ends in a simulated controller, and keeps a log;
 * pictures to show; what should be seen.
 */
#ifndef QTRI_TESTS_SUPPORT_PANEL_H
#define QTRI_TESTS_SUPPORT_PANEL_H

#include "core.h"

#include <panels/controllers.h>
#include <qtri/dither.h>
#include <qtri/frame.h>
#include <qtri_port/framebuffer.h>
#include <qtri_port/gc9a01.h>
#include <qtri_port/i2c.h>
#include <qtri_port/ili9341.h>
#include <qtri_port/ili9342.h>
#include <qtri_port/ili9488.h>
#include <qtri_port/panel.h>
#include <qtri_port/pcd8544.h>
#include <qtri_port/sh1106.h>
#include <qtri_port/sharp.h>
#include <qtri_port/ssd0323.h>
#include <qtri_port/ssd1306.h>
#include <qtri_port/ssd1309.h>
#include <qtri_port/ssd1322.h>
#include <qtri_port/ssd1327.h>
#include <qtri_port/ssd1351.h>
#include <qtri_port/ssd1680.h>
#include <qtri_port/ssd1681.h>
#include <qtri_port/st7735.h>
#include <qtri_port/st7789.h>
#include <qtri_port/st7796.h>
#include <qtri_port/uc8151.h>

/* A simulated controller at the end of a bus. */
typedef struct wire {
    chip *chip;
    qtri_bus bus;
    qtri_i2c i2c;
    uint8_t i2c_buffer[32];
    int calls, fail_at; /* the call that fails; 0: none */
    bool stuck;         /* BUSY never falls */
    size_t most_bytes;  /* of a transfer of data; 0: any number */
    size_t data_bytes;  /* that arrived, parameters among them */

    const uint8_t *sending; /* by DMA */
    uint8_t *sent;
    size_t sending_bytes;

    char log[32768]; /* c: command, d: data, r: reset, w: wait; hexadecimal bytes, 8 of data */
    size_t log_length;
} wire;

static inline void wire_log(wire *w, char what, const uint8_t *bytes, size_t count, uint32_t number)
{
    if (w->log_length + 64 > sizeof w->log) {
        return;
    }
    char *at = w->log + w->log_length;
    int n = sprintf(at, "%s%c", w->log_length > 0 ? " " : "", what);
    if (bytes == NULL) {
        n += sprintf(at + n, "%u", (unsigned)number);
    }
    for (size_t i = 0; i < count && bytes != NULL && i < 17; i++) {
        n += sprintf(at + n, "%02X", bytes[i]);
    }
    if (count > 17) {
        n += sprintf(at + n, "..(%u)", (unsigned)count);
    }
    w->log_length += (size_t)n;
}

/* Nothing may be called while DMA runs. */
static inline bool wire_call(wire *w)
{
    assert_null(w->sending);
    return ++w->calls != w->fail_at;
}

static inline bool wire_command(void *context, const uint8_t *bytes, size_t count)
{
    wire *w = (wire *)context;
    assert_true(count >= 1 && count <= 17);
    wire_log(w, 'c', bytes, count, 0);
    if (!wire_call(w)) {
        return false;
    }
    chip_send(w->chip, false, bytes, count);
    return true;
}

static inline bool wire_data(void *context, const uint8_t *bytes, size_t count)
{
    wire *w = (wire *)context;
    assert_true(count >= 1 && (w->most_bytes == 0 || count <= w->most_bytes));
    wire_log(w, 'd', bytes, count, 0);
    if (!wire_call(w)) {
        return false;
    }
    chip_send(w->chip, true, bytes, count);
    w->data_bytes += count;
    return true;
}

static inline bool wire_start(void *context, const uint8_t *bytes, size_t count)
{
    wire *w = (wire *)context;
    assert_true(count >= 1 && (w->most_bytes == 0 || count <= w->most_bytes));
    wire_log(w, 's', bytes, count, 0);
    if (!wire_call(w)) {
        return false;
    }
    w->sending = bytes;
    w->sending_bytes = count;
    w->sent = (uint8_t *)malloc(count);
    assert_non_null(w->sent);
    memcpy(w->sent, bytes, count);
    return true;
}

/* The bytes must be as they were when the transfer started. */
static inline bool wire_finish(void *context)
{
    wire *w = (wire *)context;
    assert_non_null(w->sending);
    assert_memory_equal(w->sending, w->sent, w->sending_bytes);
    chip_send(w->chip, true, w->sent, w->sending_bytes);
    w->data_bytes += w->sending_bytes;
    free(w->sent);
    w->sending = NULL;
    wire_log(w, 'f', NULL, 0, (uint32_t)w->sending_bytes);
    return wire_call(w);
}

static inline bool wire_i2c(void *context, const uint8_t *bytes, size_t count)
{
    wire *w = (wire *)context;
    assert_true(count >= 2 && count <= sizeof w->i2c_buffer);
    wire_log(w, 'i', bytes, count, 0);
    if (!wire_call(w)) {
        return false;
    }
    chip_i2c(w->chip, bytes, count);
    return true;
}

static inline void wire_wait(void *context, uint32_t ms)
{
    wire *w = (wire *)context;
    assert_null(w->sending);
    wire_log(w, 'w', NULL, 0, ms);
    chip_wait(w->chip, ms);
}

static inline void wire_reset(void *context, bool active)
{
    wire *w = (wire *)context;
    assert_null(w->sending);
    wire_log(w, 'r', NULL, 0, active);
    chip_reset_pin(w->chip, active);
}

static inline bool wire_busy(void *context)
{
    wire *w = (wire *)context;
    return w->stuck || chip_busy(w->chip);
}

typedef enum wiring { WIRE_SPI, WIRE_DMA, WIRE_I2C } wiring;

static inline void wire_init(wire *w, chip *to, wiring how)
{
    memset(w, 0, sizeof *w);
    w->chip = to;
    qtri_bus bus = {w, wire_command, wire_data, NULL, NULL, wire_wait, wire_reset, wire_busy, 0};
    w->bus = bus;
    if (how == WIRE_DMA) {
        w->bus.data_start = wire_start;
        w->bus.data_finish = wire_finish;
    } else if (how == WIRE_I2C) {
        qtri_i2c i2c = {w, wire_i2c, wire_wait, wire_reset, w->i2c_buffer, sizeof w->i2c_buffer};
        w->i2c = i2c;
        assert_ok(qtri_i2c_bus(&w->bus, &w->i2c));
    }
}

static inline void assert_chip_content(const chip *c)
{
    if (c->error[0] != '\0') {
        fail_msg("%s", c->error);
    }
}

/* The controllers that there are, each by its simulation. */
typedef enum controller {
    SSD1306_CHIP,
    SSD1309_CHIP,
    SH1106_CHIP,
    SSD0323_CHIP,
    SSD1327_CHIP,
    SSD1322_CHIP,
    SSD1680_CHIP,
    SSD1681_CHIP,
    UC8151_CHIP,
    SHARP_CHIP,
    PCD8544_CHIP,
    SSD1351_CHIP,
    ILI9341_CHIP,
    ILI9342_CHIP,
    ILI9488_CHIP,
    ST7789_CHIP,
    ST7735_CHIP,
    ST7796_CHIP,
    GC9A01_CHIP
} controller;

/* A model of display, its simulated controller and how it is connected. */
typedef struct setup {
    const char *name;
    const qtri_panel_description *description;
    wiring how;
    controller controller;
    union {
        chip chip;
        ssd1306 ssd1306;
        sh1106 sh1106;
        ssd0323 ssd0323;
        lcd lcd;
        ssd1680 ssd1680;
        ssd1351 ssd1351;
        pcd8544 pcd8544;
        sharp_lcd sharp;
        uc8151 uc8151;
    } sim;
    wire wire;
    uint8_t *memory;
    qtri_panel panel;
} setup;

enum { SETUPS = 40 };

/* A module: where its glass begins, how it is mounted and wired, memory that pins choose. */
typedef struct module_entry {
    const char *name;
    const qtri_panel_description *description;
    wiring how;
    controller controller;
    int first_column, first_row;
    bool from_right, blue_first, normally_black, from_bottom;
    int memory_width, memory_height;
} module_entry;

static inline void attach_lcd(setup *s, const module_entry *m)
{
    const int w = m->description->width, h = m->description->height;
    const lcd_glass glass = {w,
                             h,
                             m->first_column,
                             m->first_row,
                             m->from_right,
                             m->blue_first,
                             m->normally_black,
                             m->from_bottom};
    switch (m->controller) {
    case ILI9341_CHIP:
        ili9341_init(&s->sim.lcd);
        break;
    case ILI9342_CHIP:
        ili9342_init(&s->sim.lcd, &glass);
        break;
    case ILI9488_CHIP:
        ili9488_init(&s->sim.lcd, &glass);
        break;
    case ST7789_CHIP:
        st7789_init(&s->sim.lcd, &glass);
        break;
    case ST7735_CHIP:
        st7735_init(&s->sim.lcd, &glass, m->memory_width, m->memory_height);
        break;
    case ST7796_CHIP:
        st7796_init(&s->sim.lcd, &glass);
        break;
    case SSD1351_CHIP:
        ssd1351_init(&s->sim.ssd1351, &glass);
        break;
    default:
        gc9a01_init(&s->sim.lcd, &glass);
        break;
    }
}

static inline void attach(setup *s, const module_entry *m)
{
    const int w = m->description->width, h = m->description->height;
    switch (m->controller) {
    case SSD1306_CHIP:
        ssd1306_init_at(&s->sim.ssd1306, h, m->first_column);
        break;
    case SSD1309_CHIP:
        ssd1309_init(&s->sim.ssd1306);
        break;
    case SH1106_CHIP:
        sh1106_init(&s->sim.sh1106);
        break;
    case SSD0323_CHIP:
        ssd0323_init(&s->sim.ssd0323);
        break;
    case SSD1327_CHIP:
        ssd1327_init(&s->sim.ssd0323);
        break;
    case SSD1322_CHIP:
        ssd1322_init(&s->sim.ssd0323);
        break;
    case SSD1680_CHIP:
        ssd1680_init(&s->sim.ssd1680);
        break;
    case SSD1681_CHIP:
        ssd1681_init(&s->sim.ssd1680);
        break;
    case UC8151_CHIP:
        uc8151_init(&s->sim.uc8151);
        break;
    case SHARP_CHIP:
        sharp_init(&s->sim.sharp, w, h);
        break;
    case PCD8544_CHIP:
        pcd8544_init(&s->sim.pcd8544);
        break;
    default:
        attach_lcd(s, m);
        break;
    }
}

/* Number n of SETUPS, its controller fresh. */
static inline void setup_init(setup *s, int n)
{
    /* The fields after the controller: first column and row, from the right, blue first, normally
       black, from the bottom, memory. */
    static const module_entry all[SETUPS] = {
        {"SSD1306", &qtri_ssd1306, WIRE_SPI, SSD1306_CHIP, 0, 0, 0, 0, 0, 0, 0, 0},
        {"SSD1306 DMA", &qtri_ssd1306, WIRE_DMA, SSD1306_CHIP, 0, 0, 0, 0, 0, 0, 0, 0},
        {"SSD1306 I2C", &qtri_ssd1306, WIRE_I2C, SSD1306_CHIP, 0, 0, 0, 0, 0, 0, 0, 0},
        {"SSD1306 128x32", &qtri_ssd1306_128x32, WIRE_SPI, SSD1306_CHIP, 0, 0, 0, 0, 0, 0, 0, 0},
        {"SSD0323", &qtri_ssd0323, WIRE_SPI, SSD0323_CHIP, 0, 0, 0, 0, 0, 0, 0, 0},
        {"SSD0323 DMA", &qtri_ssd0323, WIRE_DMA, SSD0323_CHIP, 0, 0, 0, 0, 0, 0, 0, 0},
        {"SSD1680", &qtri_ssd1680, WIRE_SPI, SSD1680_CHIP, 0, 0, 0, 0, 0, 0, 0, 0},
        {"ILI9341", &qtri_ili9341, WIRE_SPI, ILI9341_CHIP, 0, 0, 0, 0, 0, 0, 0, 0},
        {"ILI9341 DMA", &qtri_ili9341, WIRE_DMA, ILI9341_CHIP, 0, 0, 0, 0, 0, 0, 0, 0},
        {"ST7789", &qtri_st7789, WIRE_SPI, ST7789_CHIP, 0, 0, 0, 0, 1, 0, 0, 0},
        {"ST7789 240x240", &qtri_st7789_240x240, WIRE_DMA, ST7789_CHIP, 0, 0, 0, 0, 1, 0, 0, 0},
        {"ST7789 135x240", &qtri_st7789_135x240, WIRE_SPI, ST7789_CHIP, 52, 40, 0, 0, 1, 0, 0, 0},
        {"ST7789 170x320", &qtri_st7789_170x320, WIRE_DMA, ST7789_CHIP, 35, 0, 0, 0, 1, 0, 0, 0},
        {"ST7735", &qtri_st7735, WIRE_SPI, ST7735_CHIP, 0, 0, 1, 1, 0, 1, 128, 160},
        {"ST7735 green", &qtri_st7735_green, WIRE_DMA, ST7735_CHIP, 2, 1, 1, 1, 0, 1, 132, 162},
        {"ST7735 80x160", &qtri_st7735_80x160, WIRE_SPI, ST7735_CHIP, 26, 1, 1, 1, 1, 1, 132, 162},
        {"GC9A01", &qtri_gc9a01, WIRE_SPI, GC9A01_CHIP, 0, 0, 0, 1, 1, 0, 0, 0},
        {"SSD1306 72x40", &qtri_ssd1306_72x40, WIRE_SPI, SSD1306_CHIP, 28, 0, 0, 0, 0, 0, 0, 0},
        {"SH1106", &qtri_sh1106, WIRE_SPI, SH1106_CHIP, 0, 0, 0, 0, 0, 0, 0, 0},
        {"SH1106 DMA", &qtri_sh1106, WIRE_DMA, SH1106_CHIP, 0, 0, 0, 0, 0, 0, 0, 0},
        {"SH1106 I2C", &qtri_sh1106, WIRE_I2C, SH1106_CHIP, 0, 0, 0, 0, 0, 0, 0, 0},
        {"ST7789 240x280", &qtri_st7789_240x280, WIRE_DMA, ST7789_CHIP, 0, 20, 0, 0, 1, 0, 0, 0},
        {"ST7789 172x320", &qtri_st7789_172x320, WIRE_SPI, ST7789_CHIP, 34, 0, 0, 0, 1, 0, 0, 0},
        {"ST7735 128x128", &qtri_st7735_128x128, WIRE_SPI, ST7735_CHIP, 2, 1, 1, 1, 0, 1, 132, 132},
        {"ST7735 80x160 red", &qtri_st7735_80x160_red, WIRE_SPI, ST7735_CHIP, 24, 0, 1, 1, 0, 1,
         128, 160},
        {"ST7796", &qtri_st7796, WIRE_DMA, ST7796_CHIP, 0, 0, 1, 1, 0, 0, 0, 0},
        {"ILI9488", &qtri_ili9488, WIRE_DMA, ILI9488_CHIP, 0, 0, 1, 1, 0, 0, 0, 0},
        {"ILI9342", &qtri_ili9342, WIRE_SPI, ILI9342_CHIP, 0, 0, 0, 1, 1, 0, 0, 0},
        {"SSD1351", &qtri_ssd1351, WIRE_DMA, SSD1351_CHIP, 0, 0, 0, 1, 0, 0, 0, 0},
        {"SSD1309", &qtri_ssd1309, WIRE_SPI, SSD1309_CHIP, 0, 0, 0, 0, 0, 0, 0, 0},
        {"SSD1327", &qtri_ssd1327, WIRE_SPI, SSD1327_CHIP, 0, 0, 0, 0, 0, 0, 0, 0},
        {"SSD1327 I2C", &qtri_ssd1327, WIRE_I2C, SSD1327_CHIP, 0, 0, 0, 0, 0, 0, 0, 0},
        {"SSD1322", &qtri_ssd1322, WIRE_DMA, SSD1322_CHIP, 0, 0, 0, 0, 0, 0, 0, 0},
        {"SSD1681", &qtri_ssd1681, WIRE_SPI, SSD1681_CHIP, 0, 0, 0, 0, 0, 0, 0, 0},
        {"UC8151", &qtri_uc8151, WIRE_SPI, UC8151_CHIP, 0, 0, 0, 0, 0, 0, 0, 0},
        {"Sharp 96x96", &qtri_sharp_96x96, WIRE_SPI, SHARP_CHIP, 0, 0, 0, 0, 0, 0, 0, 0},
        {"Sharp 128x128", &qtri_sharp_128x128, WIRE_SPI, SHARP_CHIP, 0, 0, 0, 0, 0, 0, 0, 0},
        {"Sharp 144x168", &qtri_sharp_144x168, WIRE_SPI, SHARP_CHIP, 0, 0, 0, 0, 0, 0, 0, 0},
        {"Sharp 400x240", &qtri_sharp_400x240, WIRE_DMA, SHARP_CHIP, 0, 0, 0, 0, 0, 0, 0, 0},
        {"PCD8544", &qtri_pcd8544, WIRE_SPI, PCD8544_CHIP, 0, 0, 0, 0, 0, 0, 0, 0},
    };
    s->name = all[n].name;
    s->description = all[n].description;
    s->how = all[n].how;
    s->controller = all[n].controller;
    attach(s, &all[n]);
    wire_init(&s->wire, &s->sim.chip, s->how);
    s->memory = NULL;
}

/* How the glass of a controller of colours is mounted, for tests to change. */
static inline lcd_glass *setup_glass(setup *s)
{
    return s->controller == SSD1351_CHIP ? &s->sim.ssd1351.glass : &s->sim.lcd.glass;
}

/* Displays that keep their picture without a refresh. */
static inline bool is_paper(const setup *s)
{
    return s->controller == SSD1680_CHIP || s->controller == SSD1681_CHIP ||
           s->controller == UC8151_CHIP;
}

static inline bool is_gray(const qtri_panel_description *d)
{
    return d->format != QTRI_PANEL_RGB565 && d->format != QTRI_PANEL_RGB666 &&
           d->format != QTRI_PANEL_XRGB8888;
}

/* The most memory that is of use, or the least. */
static inline size_t memory_bytes(const qtri_panel_description *d, bool most)
{
    if (is_gray(d)) {
        return most ? QTRI_PANEL_IMAGE_BYTES(d->width, d->height, d->format)
                    : QTRI_PANEL_ROW_BYTES(d->width, d->format);
    }
    const bool is_666 = d->format == QTRI_PANEL_RGB666;
    return most ? QTRI_PANEL_LINE_BYTES(d->width) : QTRI_PANEL_LINE_BYTES(is_666 ? 2 : 1);
}

static inline enum qtri_error setup_start(setup *s, qtri_rotation rotation, bool most)
{
    size_t bytes = memory_bytes(s->description, most);
    free(s->memory);
    s->memory = (uint8_t *)malloc(bytes);
    assert_non_null(s->memory);
    return qtri_panel_init(&s->panel, s->description, &s->wire.bus, rotation, s->memory, bytes);
}

static inline void setup_end(setup *s)
{
    if (s->wire.sending != NULL) {
        free(s->wire.sent);
        s->wire.sending = NULL;
    }
    free(s->memory);
    s->memory = NULL;
}

/* A gray ramp and triangles in colour, the same for every split into bands. */
static inline void draw_picture(const qtri_surface *surface, uint64_t seed)
{
    qtri_rgb sky = {(uint8_t)(seed * 40), 60, 110};
    qtri_surface_clear(surface, sky);
    int32_t w = surface->width * 256;
    int32_t h = surface->height * 256;
    qtri_material material = plain_material();
    material.shading = QTRI_SMOOTH;
    for (int n = 0; n < 6; n++) {
        qtri_screen_vertex v[3];
        for (int i = 0; i < 3; i++) {
            v[i] = screen_at(random_in(&seed, 0, w), random_in(&seed, 0, h));
            for (int c = 0; c < 3; c++) {
                v[i].color_8p16[c] = random_in(&seed, 0, 255) << 16;
            }
        }
        qtri_raster_triangle(surface, qtri_pipelines_default, &material, v);
    }
}

/* Levels or colours, as the display should show them: 0x00RRGGBB by row. */
static inline uint32_t *picture_expected(const qtri_surface *whole, const qtri_panel *panel)
{
    const qtri_panel_description *d = panel->description;
    int32_t w = whole->width;
    uint32_t *seen = (uint32_t *)malloc((size_t)w * (size_t)whole->height * sizeof *seen);
    uint8_t *gray = (uint8_t *)malloc((size_t)w);
    assert_true(seen != NULL && gray != NULL);
    uint8_t max_level = d->format == QTRI_PANEL_GRAY4 ? 15 : 1;
    const double most = d->format == QTRI_PANEL_RGB666 ? 63 : 31; /* of red and blue */
    for (int32_t y = 0; y < whole->height; y++) {
        qtri_surface_gray(whole, 0, y, w, gray);
        qtri_dither_row(panel->dither, max_level, 0, y, gray, w, gray);
        for (int32_t x = 0; x < w; x++) {
            qtri_rgb c = qtri_surface_pixel(whole, x, y);
            double r = floor(c.r * most / 255.0 + .5);
            double g = floor(c.g * 63 / 255.0 + .5);
            double b = floor(c.b * most / 255.0 + .5);
            uint32_t color = (uint32_t)floor(r * 255 / most + .5) << 16 |
                             (uint32_t)floor(g * 255 / 63 + .5) << 8 |
                             (uint32_t)floor(b * 255 / most + .5);
            seen[y * w + x] = is_gray(d) ? gray[x] * (0xFFFFFFu / max_level) : color;
        }
    }
    free(gray);
    return seen;
}

/* Where a pixel of the frame is on the glass, seen upright: the picture turned clockwise. */
static inline uint32_t seen_at(const setup *s, qtri_rotation rotation, int32_t x, int32_t y)
{
    int w = s->description->width;
    int h = s->description->height;
    switch (rotation) {
    case QTRI_ROTATE_90:
        return chip_pixel(&s->sim.chip, w - 1 - y, x);
    case QTRI_ROTATE_180:
        return chip_pixel(&s->sim.chip, w - 1 - x, h - 1 - y);
    case QTRI_ROTATE_270:
        return chip_pixel(&s->sim.chip, y, h - 1 - x);
    default:
        return chip_pixel(&s->sim.chip, x, y);
    }
}

static inline void assert_seen(const setup *s, const uint32_t *expected)
{
    int32_t w = qtri_panel_width(&s->panel);
    int32_t h = qtri_panel_height(&s->panel);
    assert_chip_content(&s->sim.chip);
    for (int32_t y = 0; y < h; y++) {
        for (int32_t x = 0; x < w; x++) {
            uint32_t is = seen_at(s, s->panel.rotation, x, y);
            if (is != expected[y * w + x]) {
                fail_msg("%s turned %d: pixel %d,%d is %06X, not %06X", s->name,
                         90 * (int)s->panel.rotation, (int)x, (int)y, (unsigned)is,
                         (unsigned)expected[y * w + x]);
            }
        }
    }
}

#endif
