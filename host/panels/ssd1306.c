/* SPDX-License-Identifier: MIT */
#include "controllers.h"

#include <string.h>

/* Data sheet, table 9-1; 0xAD is of revision B. */
static const chip_command commands[] = {
    {0x00, 0x1F, 0}, /* column start, page addressing mode */
    {0x20, 0x20, 1}, {0x21, 0x21, 2}, {0x22, 0x22, 2}, {0x26, 0x27, 6}, {0x29, 0x2A, 5},
    {0x2E, 0x2F, 0}, {0x40, 0x7F, 0}, {0x81, 0x81, 1}, {0x8D, 0x8D, 1}, {0xA0, 0xA1, 0},
    {0xA3, 0xA3, 2}, {0xA4, 0xA7, 0}, {0xA8, 0xA8, 1}, {0xAD, 0xAD, 1}, {0xAE, 0xAF, 0},
    {0xB0, 0xB7, 0}, {0xC0, 0xC0, 0}, {0xC8, 0xC8, 0}, {0xD3, 0xD3, 1}, {0xD5, 0xD5, 1},
    {0xD9, 0xD9, 1}, {0xDA, 0xDA, 1}, {0xDB, 0xDB, 1}, {0xE3, 0xE3, 0},
};

static void reset(chip *it)
{
    ssd1306 *s = (void *)it;
    memset(s->memory, 0xA5, sizeof s->memory); /* whatever it holds */
    s->mode = 2;
    oled_reset(it, &s->drive);
    it->window.x1 = 127;
    it->window.y1 = 7;
}

static void execute(chip *it)
{
    ssd1306 *s = (void *)it;
    chip_window *w = &it->window;
    const uint8_t *p = it->parameters;
    if (oled_execute(it, &s->drive)) {
        return;
    }
    switch (it->command) {
    case 0x20:
        chip_allow(it, p[0] <= 2);
        s->mode = p[0];
        break;
    case 0x21:
        chip_allow_range(it, p[0], p[1], 127);
        w->x = w->x0 = p[0];
        w->x1 = p[1];
        w->full = false;
        w->set = s->mode != 2;
        break;
    case 0x22:
        chip_allow_range(it, p[0], p[1], 7);
        w->y = w->y0 = p[0];
        w->y1 = p[1];
        w->full = false;
        w->set = s->mode != 2;
        break;
    case 0x2F:
        chip_reject(it, "scrolling is not simulated");
        break;
    case 0x8D:
        chip_allow(it, (p[0] & ~4) == 0x10);
        if (!s->has_pump) {
            chip_reject(it, "there is no charge pump");
        }
        s->drive.pump = (p[0] & 4) != 0;
        break;
    case 0xA8:
        chip_allow(it, p[0] >= 15 && p[0] <= 63);
        s->drive.multiplex = p[0];
        break;
    case 0xDA:
        chip_allow(it, (p[0] & ~0x30) == 0x02);
        s->drive.pins = p[0];
        break;
    case 0xDB:
        chip_allow(it, s->has_pump ? p[0] == 0x00 || p[0] == 0x20 || p[0] == 0x30
                                   : p[0] == 0x00 || p[0] == 0x34 || p[0] == 0x3C);
        break;
    default:
        break;
    }
}

static void store(chip *it, uint8_t byte)
{
    ssd1306 *s = (void *)it;
    int x = it->window.x;
    s->memory[it->window.y][s->drive.columns_reversed ? 127 - x : x] = byte; /* by segment */
    chip_advance(it, s->mode == 1);
}

static uint32_t pixel(const chip *it, int x, int y)
{
    const ssd1306 *s = (const void *)it;
    int wired = s->rows == 32 ? 0x02 : 0x12; /* the glass's rows alternate between COM halves */
    if (!s->drive.on || s->drive.pump != s->has_pump || s->drive.pins != wired ||
        s->drive.multiplex != s->rows - 1) {
        return 0;
    }
    return oled_pixel(&s->drive, s->rows, y, &s->memory[0][127 - s->first_column - x], 128);
}

static void init(ssd1306 *s, const chip_model *model, int rows)
{
    s->rows = rows;
    s->first_column = 0;
    chip_init(&s->chip, model);
}

void ssd1306_init(ssd1306 *s, int rows)
{
    static const chip_model model = CHIP_MODEL("SSD1306", commands, false);
    s->has_pump = true;
    init(s, &model, rows);
}

void ssd1309_init(ssd1306 *s)
{
    static const chip_model model = CHIP_MODEL("SSD1309", commands, false);
    s->has_pump = false;
    init(s, &model, 64);
}

void ssd1306_init_at(ssd1306 *s, int rows, int first_column)
{
    ssd1306_init(s, rows);
    s->first_column = first_column;
}
