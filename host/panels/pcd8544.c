/* SPDX-License-Identifier: MIT */
#include "controllers.h"

#include <string.h>

/* All but 0x00 and those of the function set mean one thing or another by its bit H. */
static const chip_command commands[] = {{0x00, 0xFF, 0}};

enum { EXTENDED = 0x01, DOWN_FIRST = 0x02, POWER_DOWN = 0x04 };

static void reset(chip *it)
{
    pcd8544 *s = (void *)it;
    memset(s->memory, 0x5A, sizeof s->memory);
    s->function = POWER_DOWN;
    s->display = s->vop = s->bias = 0;
    it->window.set = true;
    it->window.x1 = 83;
    it->window.y1 = 5;
}

static void execute_extended(chip *it)
{
    pcd8544 *s = (void *)it;
    const int command = it->command;
    if (command >= 0x80) {
        s->vop = command & 0x7F;
    } else if ((command & 0xF8) == 0x10) {
        s->bias = command & 7;
    } else if ((command & 0xFC) != 0x04) { /* the temperature coefficient */
        chip_reject(it, "extended command 0x%02X", command);
    }
}

static void execute(chip *it)
{
    pcd8544 *s = (void *)it;
    chip_window *w = &it->window;
    const int command = it->command;
    if ((command & 0xF8) == 0x20) {
        s->function = command & 7;
    } else if (command == 0x00) {
        return;
    } else if ((s->function & EXTENDED) != 0) {
        execute_extended(it);
    } else if (command >= 0x80 && command - 0x80 <= 83) {
        w->x = command - 0x80;
    } else if ((command & 0xF8) == 0x40 && (command & 7) <= 5) {
        w->y = command & 7;
    } else if ((command & 0xFA) == 0x08) {
        s->display = command & 5;
    } else {
        chip_reject(it, "command 0x%02X", command);
    }
    w->full = false;
}

/* The counters wrap: nothing is past the end. */
static void store(chip *it, uint8_t byte)
{
    pcd8544 *s = (void *)it;
    s->memory[it->window.y][it->window.x] = byte;
    chip_advance(it, (s->function & DOWN_FIRST) != 0);
    it->window.full = false;
}

/* Between 5.5 and 7.5 V, 3.06 and .06 a step, the glass of 48 rows has contrast. */
static uint32_t pixel(const chip *it, int x, int y)
{
    const pcd8544 *s = (const void *)it;
    if ((s->function & POWER_DOWN) != 0 || s->bias != 3 || s->vop < 41 || s->vop > 74) {
        return 0;
    }
    const bool bit = (s->memory[y / 8][x] >> (y % 8) & 1) != 0;
    const bool dark[6] = {false, true, false, false, bit, !bit}; /* D and E: bits 2 and 0 */
    return dark[s->display] ? 0 : 0xFFFFFF;
}

void pcd8544_init(pcd8544 *s)
{
    static const chip_model model = CHIP_MODEL("PCD8544", commands, false);
    chip_init(&s->chip, &model);
}
