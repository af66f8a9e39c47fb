/* SPDX-License-Identifier: MIT */
#include "controllers.h"

#include <string.h>

/* Data sheet, "command table". */
static const chip_command commands[] = {
    {0x00, 0x1F, 0}, /* column address: low and high half */
    {0x30, 0x33, 0}, {0x40, 0x7F, 0}, {0x81, 0x81, 1}, {0xA0, 0xA1, 0},
    {0xA4, 0xA7, 0}, {0xA8, 0xA8, 1}, {0xAD, 0xAD, 1}, {0xAE, 0xAF, 0},
    {0xB0, 0xB7, 0}, {0xC0, 0xC8, 0}, {0xD3, 0xD3, 1}, {0xD5, 0xD5, 1},
    {0xD9, 0xD9, 1}, {0xDA, 0xDA, 1}, {0xDB, 0xDB, 1}, {0xE3, 0xE3, 0},
};

static void reset(chip *it)
{
    sh1106 *s = (void *)it;
    memset(s->memory, 0xA5, sizeof s->memory); /* whatever it holds */
    s->column = s->page = 0;
    oled_reset(it, &s->drive);
    s->drive.pump = true;
}

/* Data go to the column and page that are set; the page ends where the memory does. */
static void move(chip *it)
{
    sh1106 *s = (void *)it;
    if (s->column >= 132) {
        chip_reject(it, "column %d", s->column);
    }
    const int columns[2] = {0, 131}, pages[2] = {s->page, s->page};
    chip_open_window(it, columns, pages, s->column, s->page);
}

static void execute(chip *it)
{
    sh1106 *s = (void *)it;
    const uint8_t *p = it->parameters;
    int command = it->command;
    if (oled_execute(it, &s->drive)) {
        return;
    }
    switch (command) {
    case 0x81:
    case 0xD5:
    case 0xDB:
        break;
    case 0xA8:
        chip_allow(it, p[0] <= 63);
        s->drive.multiplex = p[0];
        break;
    case 0xAD:
        chip_allow(it, (p[0] & ~1) == 0x8A);
        s->drive.pump = (p[0] & 1) != 0;
        break;
    case 0xDA:
        chip_allow(it, (p[0] & ~0x10) == 0x02);
        s->drive.pins = p[0];
        break;
    default:
        if (command >= 0xB0 && command <= 0xB7) {
            s->page = command & 7;
            move(it);
        } else if (command < 0x10) {
            s->column = (s->column & 0xF0) | command;
            move(it);
        } else if (command < 0x20) {
            s->column = (s->column & 15) | (command & 15) << 4;
            it->window.set = false; /* until the low half is there too */
        }
        break;
    }
}

static void store(chip *it, uint8_t byte)
{
    sh1106 *s = (void *)it;
    int x = it->window.x;
    s->memory[it->window.y][s->drive.columns_reversed ? 131 - x : x] = byte; /* by segment */
    chip_advance(it, false);
}

static uint32_t pixel(const chip *it, int x, int y)
{
    const sh1106 *s = (const void *)it;
    if (!s->drive.on || !s->drive.pump || s->drive.pins != 0x12 || s->drive.multiplex != 63) {
        return 0;
    }
    return oled_pixel(&s->drive, 64, y, &s->memory[0][129 - x], 132);
}

void sh1106_init(sh1106 *s)
{
    static const chip_model model = CHIP_MODEL("SH1106", commands, false);
    chip_init(&s->chip, &model);
}
