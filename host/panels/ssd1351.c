/* SPDX-License-Identifier: MIT */
#include "controllers.h"

#include <string.h>

static const chip_command commands[] = {
    {0x15, 0x15, 2}, {0x5C, 0x5C, CHIP_STREAM}, {0x75, 0x75, 2}, {0xA0, 0xA2, 1}, {0xA4, 0xA7, 0},
    {0xAB, 0xAB, 1}, {0xAD, 0xAD, 0},           {0xAE, 0xAF, 0}, {0xB0, 0xB0, 0}, {0xB1, 0xB1, 1},
    {0xB2, 0xB2, 3}, {0xB3, 0xB3, 1},           {0xB4, 0xB4, 3}, {0xB5, 0xB6, 1}, {0xB9, 0xB9, 0},
    {0xBB, 0xBB, 1}, {0xBE, 0xBE, 1},           {0xC1, 0xC1, 3}, {0xC7, 0xC7, 1}, {0xCA, 0xCA, 1},
    {0xD1, 0xD1, 0}, {0xE3, 0xE3, 0},           {0xFD, 0xFD, 1},
};

enum {
    DOWN_FIRST = 0x01,
    COLUMNS_REVERSED = 0x02,
    COLORS_SWAPPED = 0x04,
    COMS_REVERSED = 0x10,
    COMS_SPLIT = 0x20,
    COLORS_16_BITS = 0x40
};

static ssd1351 *self(chip *it)
{
    return (ssd1351 *)(void *)it;
}

static void reset(chip *it)
{
    ssd1351 *s = self(it);
    memset(s->memory, 0x5A, sizeof s->memory);
    s->remap = 0x40;
    s->unlocked = 0x12;
    s->on = s->inverse = s->half = false;
    for (int i = 0; i < 2; i++) {
        s->ranges[i][0] = 0;
        s->ranges[i][1] = 127;
    }
    it->ready_ms = it->now_ms + 100;
}

static void set_range(chip *it, int range[2])
{
    range[0] = it->parameters[0];
    range[1] = it->parameters[1];
    if (range[0] > range[1] || range[1] > 127) {
        chip_reject(it, "command 0x%02X: range %d..%d", it->command, range[0], range[1]);
    }
}

static void begin_write(chip *it)
{
    ssd1351 *s = self(it);
    if ((s->remap & 0xC0) != COLORS_16_BITS) {
        chip_reject(it, "data in address mode 0x%02X, only 16 bits are simulated", s->remap);
    }
    const chip_window window = {s->ranges[0][0],
                                s->ranges[0][1],
                                s->ranges[1][0],
                                s->ranges[1][1],
                                s->ranges[0][0],
                                s->ranges[1][0],
                                true,
                                false};
    it->window = window;
    s->half = false;
}

static void execute(chip *it)
{
    ssd1351 *s = self(it);
    const uint8_t command = it->command, p = it->parameters[0];
    const bool is_second = (command >= 0xB1 && command <= 0xB4) || command == 0xBB ||
                           command == 0xBE || command == 0xC1 || command == 0xA2;
    if (is_second && s->unlocked != 0xB1) {
        chip_reject(it, "command 0x%02X is locked", command);
    }
    if (s->half) {
        chip_reject(it, "command 0x%02X in the middle of a pixel", command);
    }
    switch (command) {
    case 0x15:
    case 0x75:
        set_range(it, s->ranges[command == 0x75]);
        break;
    case 0x5C:
        begin_write(it);
        break;
    case 0xA0:
        s->remap = p;
        it->window.set = false;
        break;
    case 0xA1:
    case 0xA2:
        if (p != 0) {
            chip_reject(it, "a start line or offset of %d is not simulated", p);
        }
        break;
    case 0xA6:
    case 0xA7:
        s->inverse = command == 0xA7;
        break;
    case 0xAE:
    case 0xAF:
        s->on = command == 0xAF;
        break;
    case 0xCA:
        if (p != 127) {
            chip_reject(it, "%d rows", p + 1);
        }
        break;
    case 0xFD:
        s->unlocked = p;
        break;
    default:
        break;
    }
}

/* By segment and COM: the address mode of the time of writing counts. */
static void store(chip *it, uint8_t byte)
{
    ssd1351 *s = self(it);
    if (!s->half) {
        s->high = byte;
        s->half = true;
        return;
    }
    s->half = false;
    const int x = it->window.x;
    const int segment = (s->remap & COLUMNS_REVERSED) != 0 ? 127 - x : x;
    s->memory[it->window.y][segment] = (uint16_t)(s->high << 8 | byte);
    chip_advance(it, (s->remap & DOWN_FIRST) != 0);
}

/* The glass of modules wants colours swapped: blue is the first segment of a pixel. */
static uint32_t pixel(const chip *it, int x, int y)
{
    const ssd1351 *s = (const ssd1351 *)(const void *)it;
    if (!s->on || (s->remap & COMS_SPLIT) == 0) {
        return 0;
    }
    const lcd_glass *g = &s->glass;
    const int row = ((s->remap & COMS_REVERSED) != 0) != g->rows_from_bottom ? y : 127 - y;
    const uint32_t c = s->memory[row][g->columns_from_right ? 127 - x : x];
    const uint32_t first = ((c >> 11) * 255 + 15) / 31, last = ((c & 31) * 255 + 15) / 31;
    const uint32_t green = ((c >> 5 & 63) * 255 + 31) / 63;
    const bool swapped = ((s->remap & COLORS_SWAPPED) != 0) == g->blue_first;
    const uint32_t seen =
        swapped ? first << 16 | green << 8 | last : last << 16 | green << 8 | first;
    return s->inverse != g->normally_black ? ~seen & 0xFFFFFF : seen;
}

void ssd1351_init(ssd1351 *s, const lcd_glass *glass)
{
    static const chip_model model = CHIP_MODEL("SSD1351", commands, true);
    s->glass = *glass;
    s->chip.busy_pin = false;
    chip_init(&s->chip, &model);
}
