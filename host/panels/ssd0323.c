/* SPDX-License-Identifier: MIT */
#include "controllers.h"

#include <string.h>

/* The command table, without the graphic acceleration commands 0x23..0x2F. */
static const chip_command commands[] = {
    {0x15, 0x15, 2}, {0x75, 0x75, 2}, {0x81, 0x81, 1}, {0x84, 0x86, 0}, {0xA0, 0xA2, 1},
    {0xA4, 0xA7, 0}, {0xA8, 0xA8, 1}, {0xAD, 0xAD, 1}, {0xAE, 0xAF, 0}, {0xB0, 0xB4, 1},
    {0xB8, 0xB8, 8}, {0xBC, 0xBC, 1}, {0xBE, 0xBF, 1}, {0xE3, 0xE3, 0},
};

enum {
    COLUMNS_REVERSED = 0x01,
    NIBBLES_SWAPPED = 0x02,
    VERTICAL = 0x04,
    COMS_REVERSED = 0x10,
    COMS_SPLIT = 0x40
};

static ssd0323 *self(chip *it)
{
    return (ssd0323 *)(void *)it;
}

static void reset(chip *it)
{
    ssd0323 *s = self(it);
    memset(s->memory, 0x5A, sizeof s->memory);
    s->remap = s->offset = s->start_line = 0;
    s->multiplex = 79;
    s->mode = 0xA4;
    s->on = false;
    it->window.x1 = 63;
    it->window.y1 = 79;
}

static void allow(chip *it, bool allowed)
{
    if (!allowed) {
        chip_reject(it, "command 0x%02X: parameter 0x%02X", it->command, it->parameters[0]);
    }
}

static void range(chip *it, int most)
{
    if (it->parameters[0] > it->parameters[1] || it->parameters[1] > most) {
        chip_reject(it, "command 0x%02X: range %d..%d", it->command, it->parameters[0],
                    it->parameters[1]);
    }
}

static void execute(chip *it)
{
    ssd0323 *s = self(it);
    chip_window *w = &it->window;
    const uint8_t *p = it->parameters;
    switch (it->command) {
    case 0x15:
        range(it, 63);
        w->x = w->x0 = p[0];
        w->x1 = p[1];
        w->set = true;
        w->full = false;
        break;
    case 0x75:
        range(it, 79);
        w->y = w->y0 = p[0];
        w->y1 = p[1];
        w->set = true;
        w->full = false;
        break;
    case 0x81:
        allow(it, p[0] <= 127);
        break;
    case 0xA0:
        allow(it, (p[0] & ~0x57) == 0);
        s->remap = p[0];
        break;
    case 0xA1:
        allow(it, p[0] <= 79);
        s->start_line = p[0];
        break;
    case 0xA2:
        allow(it, p[0] <= 79);
        s->offset = p[0];
        break;
    case 0xA4:
    case 0xA5:
    case 0xA6:
    case 0xA7:
        s->mode = it->command;
        break;
    case 0xA8:
        allow(it, p[0] >= 15 && p[0] <= 79);
        s->multiplex = p[0];
        break;
    case 0xAD:
        allow(it, (p[0] & ~1) == 2);
        break;
    case 0xAE:
    case 0xAF:
        s->on = it->command == 0xAF;
        break;
    default:
        break;
    }
}

static void store(chip *it, uint8_t byte)
{
    ssd0323 *s = self(it);
    s->memory[it->window.y][it->window.x] = byte;
    chip_advance(it, (s->remap & VERTICAL) != 0);
}

/* Without remapping, a byte's low half is the even segment. */
static uint32_t pixel(const chip *it, int x, int y)
{
    const ssd0323 *s = (const ssd0323 *)(const void *)it;
    if (!s->on || (s->remap & COMS_SPLIT) == 0 || s->multiplex != 63 || s->mode == 0xA6) {
        return 0;
    }
    if (s->mode == 0xA5) {
        return 0xFFFFFF;
    }
    int column = (s->remap & COLUMNS_REVERSED) != 0 ? 63 - x / 2 : x / 2;
    int line = (s->remap & COMS_REVERSED) != 0 ? y : 63 - y;
    int row = (line + s->start_line + s->offset - 76 + 80 + s->first_row) % 80;
    bool high = (x % 2 != 0) != ((s->remap & NIBBLES_SWAPPED) != 0);
    int level = high ? s->memory[row][column] >> 4 : s->memory[row][column] & 15;
    level = s->mode == 0xA7 ? 15 - level : level;
    return (uint32_t)level * 0x111111;
}

void ssd0323_init(ssd0323 *s)
{
    static const chip_model model = {"SSD0323", commands, sizeof commands / sizeof commands[0],
                                     false,     reset,    execute,
                                     store,     pixel};
    s->first_row = 0;
    s->chip.busy_pin = false;
    chip_init(&s->chip, &model);
}
