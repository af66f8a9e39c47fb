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

static void reset(chip *it)
{
    ssd1351 *s = (void *)it;
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

static void begin_write(chip *it)
{
    ssd1351 *s = (void *)it;
    if ((s->remap & 0xC0) != COLORS_16_BITS) {
        chip_reject(it, "data in address mode 0x%02X, only 16 bits are simulated", s->remap);
    }
    chip_open_window(it, s->ranges[0], s->ranges[1], s->ranges[0][0], s->ranges[1][0]);
    s->half = false;
}

static void execute(chip *it)
{
    ssd1351 *s = (void *)it;
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
        s->ranges[command == 0x75][0] = p;
        s->ranges[command == 0x75][1] = it->parameters[1];
        chip_allow_range(it, p, it->parameters[1], 127);
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
    ssd1351 *s = (void *)it;
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
    const ssd1351 *s = (const void *)it;
    if (!s->on || (s->remap & COMS_SPLIT) == 0) {
        return 0;
    }
    const lcd_glass *g = &s->glass;
    const int row = ((s->remap & COMS_REVERSED) != 0) != g->rows_from_bottom ? y : 127 - y;
    const uint32_t c = s->memory[row][g->columns_from_right ? 127 - x : x];
    const bool swapped = ((s->remap & COLORS_SWAPPED) != 0) != g->blue_first;
    return lcd_glass_shows(g, lcd_widened(c >> 11, 31), lcd_widened(c >> 5 & 63, 63),
                           lcd_widened(c & 31, 31), swapped, s->inverse);
}

void ssd1351_init(ssd1351 *s, const lcd_glass *glass)
{
    static const chip_model model = CHIP_MODEL("SSD1351", commands, true);
    s->glass = *glass;
    chip_init(&s->chip, &model);
}
