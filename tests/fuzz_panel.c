/* SPDX-License-Identifier: MIT */
/*
 * Fuzz target: panels on buses that fail, with any module, memory, rotation, surface and rectangle.
 * What is sent lies in memory that is the panel's or the surface's, DMA is never disturbed, each
 * start has one finish, and after a failure nothing more is called by that function.
 */
#include <qtri_port/gc9a01.h>
#include <qtri_port/i2c.h>
#include <qtri_port/ili9341.h>
#include <qtri_port/ili9488.h>
#include <qtri_port/panel.h>
#include <qtri_port/pcd8544.h>
#include <qtri_port/sh1106.h>
#include <qtri_port/sharp.h>
#include <qtri_port/ssd0323.h>
#include <qtri_port/ssd1306.h>
#include <qtri_port/ssd1322.h>
#include <qtri_port/ssd1327.h>
#include <qtri_port/ssd1351.h>
#include <qtri_port/ssd1680.h>
#include <qtri_port/ssd1681.h>
#include <qtri_port/st7735.h>
#include <qtri_port/st7789.h>
#include <qtri_port/uc8151.h>

#include <qtri.h>

#include <stdlib.h>
#include <string.h>

static const qtri_panel_description *const descriptions[] = {
    &qtri_ssd1306,        &qtri_ssd1306_128x32, &qtri_ssd1306_72x40,  &qtri_sh1106,
    &qtri_ssd0323,        &qtri_ssd1680,        &qtri_ili9341,        &qtri_st7789,
    &qtri_st7789_135x240, &qtri_st7789_170x320, &qtri_st7735,         &qtri_st7735_green,
    &qtri_st7735_80x160,  &qtri_gc9a01,         &qtri_st7789_240x240, &qtri_ili9488,
    &qtri_ssd1351,        &qtri_ssd1327,        &qtri_ssd1322,        &qtri_ssd1681,
    &qtri_uc8151,         &qtri_sharp_96x96,    &qtri_sharp_400x240,  &qtri_pcd8544};

typedef struct reader {
    const uint8_t *data;
    size_t left;
} reader;

static uint32_t take(reader *r, int bytes)
{
    uint32_t value = 0;
    for (int i = 0; i < bytes; i++) {
        value = value << 8 | (r->left > 0 ? *r->data : 0);
        r->data += r->left > 0;
        r->left -= r->left > 0;
    }
    return value;
}

typedef struct wire {
    uint32_t fails_at, calls; /* the call that fails, 0: none */
    size_t most_bytes;
    const uint8_t *sending;
    size_t sending_bytes;
    uint32_t sum, sent_sum;
    bool failed;
} wire;

static void require(bool holds)
{
    if (!holds) {
        abort();
    }
}

static uint32_t sum_of(const uint8_t *bytes, size_t count)
{
    uint32_t sum = 1;
    for (size_t i = 0; i < count; i++) {
        sum = sum * 31 + bytes[i];
    }
    return sum;
}

static bool call(wire *w)
{
    require(w->sending == NULL && !w->failed);
    w->calls++;
    w->failed = w->calls == w->fails_at;
    return !w->failed;
}

static bool command(void *context, const uint8_t *bytes, size_t count)
{
    wire *w = context;
    require(count >= 1 && count <= 17);
    w->sum += sum_of(bytes, count);
    return call(w);
}

static bool data(void *context, const uint8_t *bytes, size_t count)
{
    wire *w = context;
    require(count >= 1 && (w->most_bytes == 0 || count <= w->most_bytes));
    w->sum += sum_of(bytes, count);
    return call(w);
}

static bool data_start(void *context, const uint8_t *bytes, size_t count)
{
    wire *w = context;
    const bool starts = data(context, bytes, count);
    if (starts) {
        w->sending = bytes;
        w->sending_bytes = count;
        w->sent_sum = sum_of(bytes, count);
    }
    return starts;
}

static bool data_finish(void *context)
{
    wire *w = context;
    require(w->sending != NULL);
    require(sum_of(w->sending, w->sending_bytes) == w->sent_sum);
    w->sending = NULL;
    w->calls++;
    w->failed = w->failed || w->calls == w->fails_at;
    return !w->failed;
}

static bool i2c_write(void *context, const uint8_t *bytes, size_t count)
{
    wire *w = context;
    require(count >= 2);
    w->sum += sum_of(bytes, count);
    return call(w);
}

static void wait_ms(void *context, uint32_t ms)
{
    (void)ms;
    require(((wire *)context)->sending == NULL);
}

static void reset(void *context, bool active)
{
    (void)active;
    require(((wire *)context)->sending == NULL);
}

static bool busy(void *context)
{
    wire *w = context;
    w->sum++;
    return w->sum % 7 == 0;
}

static void init_bus(qtri_bus *bus, qtri_i2c *i2c, uint8_t *buffer, wire *w, uint32_t choices)
{
    memset(bus, 0, sizeof *bus);
    memset(i2c, 0, sizeof *i2c);
    bus->context = w;
    bus->command = command;
    bus->data = data;
    if (choices & 1) {
        bus->data_start = data_start;
        bus->data_finish = data_finish;
    }
    bus->wait_ms = wait_ms;
    bus->reset = choices & 2 ? reset : NULL;
    bus->busy = choices & 4 ? busy : NULL;
    bus->most_bytes = w->most_bytes;
    if (choices & 8) {
        i2c->context = w;
        i2c->write = i2c_write;
        i2c->wait_ms = wait_ms;
        i2c->buffer = buffer;
        i2c->bytes = 18 + (choices >> 4) % 16;
        if (qtri_i2c_bus(bus, i2c) != QTRI_OK) {
            abort();
        }
    }
}

static void write_some(qtri_panel *panel, wire *w, reader *r, int32_t width, int32_t height)
{
    static const qtri_format *const formats[] = {&qtri_rgb565, &qtri_rgb565_swapped, &qtri_gray8,
                                                 &qtri_xrgb8888, &qtri_rgb888};
    const qtri_format *format = formats[take(r, 1) % 5];
    const uint32_t kind = take(r, 1);
    const int32_t first = (int32_t)take(r, 2) % height;
    const int32_t rows = 1 + (int32_t)take(r, 1) % 20;
    if (kind % 16 == 0) {
        width++; /* not the panel's frame */
    }
    const size_t bytes = QTRI_BAND_BYTES((size_t)width, (size_t)rows, format->pixels->bytes);
    void *memory = calloc(1, bytes);
    qtri_surface surface;
    if (memory != NULL &&
        qtri_surface_init(&surface, format, width, height, first, rows, memory, bytes) == QTRI_OK) {
        const qtri_rgb color = {(uint8_t)kind, (uint8_t)first, (uint8_t)rows};
        qtri_surface_clear(&surface, color);
        enum qtri_error error;
        if (kind & 1) {
            error = qtri_panel_write(panel, &surface);
        } else {
            qtri_rect rect;
            rect.x0 = (int16_t)take(r, 2);
            rect.y0 = (int16_t)take(r, 2);
            rect.x1 = (int16_t)take(r, 2);
            rect.y1 = (int16_t)take(r, 2);
            error = qtri_panel_write_rect(panel, &surface, rect);
        }
        require(error == QTRI_OK || w->sending == NULL);
        require((error == QTRI_ERROR_BUS) == w->failed);
        if (w->sending != NULL) {
            require(qtri_panel_finish(panel) == (w->failed ? QTRI_ERROR_BUS : QTRI_OK) ||
                    w->failed);
        }
        require(w->sending == NULL);
    }
    free(memory);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    reader r = {bytes, size};
    wire w = {0, 0, 0, NULL, 0, 0, 0, false};
    qtri_bus bus;
    qtri_i2c i2c;
    uint8_t buffer[40];
    const qtri_panel_description *d =
        descriptions[take(&r, 1) % (sizeof descriptions / sizeof descriptions[0])];
    w.fails_at = take(&r, 1) % 3 == 0 ? take(&r, 1) : 0;
    w.most_bytes = take(&r, 1) % 3 == 0 ? 2 * (size_t)(8 + take(&r, 1)) : 0;
    init_bus(&bus, &i2c, buffer, &w, take(&r, 1));
    qtri_module module = {false, false, false, false, 0, 0};
    const uint32_t choices = take(&r, 1);
    module.swap_red_blue = (choices & 1) != 0;
    module.invert = (choices & 2) != 0;
    module.mirror_columns = (choices & 4) != 0;
    module.mirror_rows = (choices & 8) != 0;
    module.column = (int16_t)(choices & 16 ? take(&r, 2) : 0);
    module.row = (int16_t)(choices & 32 ? take(&r, 2) : 0);
    const size_t size_of_memory = take(&r, 2) % 20000;
    void *memory = malloc(size_of_memory + 1);
    if (memory == NULL) {
        return 0;
    }
    qtri_panel panel;
    enum qtri_error error =
        qtri_panel_init_module(&panel, d, choices & 64 ? &module : NULL, &bus,
                               (qtri_rotation)(take(&r, 1) % 5), memory, size_of_memory);
    require(w.sending == NULL && (error == QTRI_ERROR_BUS) == w.failed);
    for (int n = 0; n < 8 && error == QTRI_OK && r.left > 0; n++) {
        w.failed = false;
        write_some(&panel, &w, &r, qtri_panel_width(&panel), qtri_panel_height(&panel));
        if (take(&r, 1) % 8 == 0) {
            w.failed = false;
            (void)qtri_panel_refresh(&panel);
            require(w.sending == NULL);
        }
    }
    free(memory);
    return 0;
}
