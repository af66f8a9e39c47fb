/* SPDX-License-Identifier: MIT */
#include "controllers.h"

#include <string.h>

/* The command table, without what reads and the waveforms of registers. */
static const chip_command commands[] = {
    {0x00, 0x00, 1}, {0x01, 0x01, 5},           {0x02, 0x02, 0}, {0x03, 0x03, 1},
    {0x04, 0x05, 0}, {0x06, 0x06, 3},           {0x07, 0x07, 1}, {0x10, 0x10, CHIP_STREAM},
    {0x11, 0x12, 0}, {0x13, 0x13, CHIP_STREAM}, {0x30, 0x30, 1}, {0x41, 0x41, 1},
    {0x50, 0x50, 1}, {0x60, 0x60, 1},           {0x61, 0x61, 3}, {0x82, 0x82, 1},
    {0x90, 0x90, 7}, {0x91, 0x92, 0},           {0xE3, 0xE3, 1},
};

enum { RESET_MS = 10, POWER_MS = 40, REFRESH_MS = 2000 };

static void reset(chip *it)
{
    uc8151 *s = (void *)it;
    s->panel = 0x0F;
    s->interval = 0xD7;
    s->resolution[0] = s->resolution[1] = 0;
    s->powered = s->partial = false;
    it->ready_ms = it->now_ms + RESET_MS;
}

/* Columns in eights: the first one's low bits are 0, the last one's 1. */
static void set_window(chip *it)
{
    uc8151 *s = (void *)it;
    const uint8_t *p = it->parameters;
    s->range[0][0] = p[0];
    s->range[0][1] = p[1];
    s->range[1][0] = p[2] << 8 | p[3];
    s->range[1][1] = p[4] << 8 | p[5];
    if ((p[0] & 7) != 0 || (p[1] & 7) != 7 || p[0] > p[1] || p[1] > 127 ||
        s->range[1][0] > s->range[1][1] || s->range[1][1] > 295) {
        chip_reject(it, "window %d..%d, %d..%d", p[0], p[1], s->range[1][0], s->range[1][1]);
    }
}

static void begin_write(chip *it)
{
    uc8151 *s = (void *)it;
    const int all[2][2] = {{0, 15}, {0, 295}};
    const int part[2][2] = {{s->range[0][0] / 8, s->range[0][1] / 8},
                            {s->range[1][0], s->range[1][1]}};
    const int(*range)[2] = s->partial ? part : all;
    chip_open_window(it, range[0], range[1], range[0][0], range[1][0]);
    if (it->command == 0x10) {
        chip_reject(it, "old pictures are not simulated");
    }
}

static void show(chip *it)
{
    uc8151 *s = (void *)it;
    if (!s->powered) {
        chip_reject(it, "a refresh without power");
    }
    if (s->partial) {
        chip_reject(it, "a refresh of a part is not simulated");
    }
    memcpy(s->shown, s->memory, sizeof s->shown);
    s->refreshes++;
    it->ready_ms = it->now_ms + REFRESH_MS;
}

static void execute(chip *it)
{
    uc8151 *s = (void *)it;
    const uint8_t *p = it->parameters;
    switch (it->command) {
    case 0x00:
        s->panel = p[0];
        break;
    case 0x02:
    case 0x04:
        s->powered = it->command == 0x04;
        it->ready_ms = it->now_ms + POWER_MS;
        break;
    case 0x10:
    case 0x13:
        begin_write(it);
        break;
    case 0x12:
        show(it);
        break;
    case 0x50:
        s->interval = p[0];
        break;
    case 0x61:
        s->resolution[0] = p[0];
        s->resolution[1] = p[1] << 8 | p[2];
        break;
    case 0x90:
        set_window(it);
        break;
    case 0x91:
    case 0x92:
        s->partial = it->command == 0x91;
        break;
    default:
        break;
    }
}

static void store(chip *it, uint8_t byte)
{
    uc8151 *s = (void *)it;
    s->memory[it->window.y][it->window.x] = byte;
    chip_advance(it, false);
}

/* Scans up, shifts right, booster on, black and white, waveforms of its own; 1 is white. */
static uint32_t pixel(const chip *it, int x, int y)
{
    const uc8151 *s = (const void *)it;
    if (s->panel != 0x9F || s->resolution[0] != 128 || s->resolution[1] != 296) {
        return 0x808080; /* not driven as the glass is wired */
    }
    const bool bit = (s->shown[y][x / 8] >> (7 - x % 8) & 1) != 0;
    return bit == ((s->interval & 0x10) != 0) ? 0xFFFFFF : 0;
}

void uc8151_init(uc8151 *s)
{
    static const chip_model model = CHIP_MODEL("UC8151", commands, true);
    memset(s->memory, 0xC3, sizeof s->memory);
    memset(s->shown, 0xC3, sizeof s->shown);
    s->refreshes = 0;
    chip_init(&s->chip, &model);
    s->chip.busy_pin = true;
}
