/* SPDX-License-Identifier: MIT */
#include "controllers.h"

#include <string.h>

/* Data sheet, section 7; commands that read are left out. */
static const chip_command commands[] = {
    {0x01, 0x01, 3},           {0x03, 0x03, 1}, {0x04, 0x04, 3}, {0x0C, 0x0C, 4},
    {0x10, 0x11, 1},           {0x12, 0x12, 0}, {0x18, 0x18, 1}, {0x1A, 0x1A, 2},
    {0x20, 0x20, 0},           {0x21, 0x21, 2}, {0x22, 0x22, 1}, {0x24, 0x24, CHIP_STREAM},
    {0x26, 0x26, CHIP_STREAM}, {0x2B, 0x2B, 2}, {0x2C, 0x2C, 1}, {0x32, 0x32, 153},
    {0x37, 0x38, 10},          {0x3C, 0x3C, 1}, {0x3F, 0x3F, 1}, {0x44, 0x44, 2},
    {0x45, 0x45, 4},           {0x46, 0x47, 1}, {0x4E, 0x4E, 1}, {0x4F, 0x4F, 2},
    {0x7F, 0x7F, 0},
};

enum { X_UP = 1, Y_UP = 2, Y_FIRST = 4 };
enum { RESET_MS = 10, REFRESH_MS = 2000, PARTIAL_MS = 400 };

static void reset(chip *it)
{
    ssd1680 *s = (void *)it;
    s->gates = s->last_y + 1;
    s->entry = X_UP | Y_UP;
    s->x[0] = s->y[0] = 0;
    s->x[1] = s->last_x;
    s->y[1] = s->last_y;
    s->counter_x = s->counter_y = 0;
    s->update = 0xFF;
    s->options[0] = s->options[1] = 0;
    s->counters_set = false;
    it->ready_ms = it->now_ms + RESET_MS;
}

static bool between(int value, int a, int b)
{
    return a <= b ? value >= a && value <= b : value >= b && value <= a;
}

static void begin_write(chip *it)
{
    ssd1680 *s = (void *)it;
    bool x_up = (s->entry & X_UP) != 0;
    bool y_up = (s->entry & Y_UP) != 0;
    if (s->x[0] > s->last_x || s->x[1] > s->last_x ||
        (s->x[0] != s->x[1] && x_up != (s->x[0] < s->x[1]))) {
        chip_reject(it, "x addresses %d..%d in entry mode %d", s->x[0], s->x[1], s->entry);
    }
    if (s->y[0] > s->last_y || s->y[1] > s->last_y ||
        (s->y[0] != s->y[1] && y_up != (s->y[0] < s->y[1]))) {
        chip_reject(it, "y addresses %d..%d in entry mode %d", s->y[0], s->y[1], s->entry);
    }
    if (!s->counters_set || !between(s->counter_x, s->x[0], s->x[1]) ||
        !between(s->counter_y, s->y[0], s->y[1])) {
        chip_reject(it, "address counters %d, %d are not set in the window", s->counter_x,
                    s->counter_y);
    }
    chip_open_window(it, s->x, s->y, s->counter_x, s->counter_y);
    s->counters_set = false;
}

/*
 * Waveform 2 drives pixels that differ between both memories. One that the second does not hold as
 * it is shown would be driven from a state that it is not in.
 */
static void show_changes(chip *it)
{
    ssd1680 *s = (void *)it;
    if ((s->options[0] & 0xF0) != 0) {
        chip_reject(it, "a partial refresh without the second memory");
    }
    const size_t bytes = ((size_t)s->width + 7) / 8;
    for (int y = 0; y < s->height; y++) {
        const uint8_t *is = &s->shown[s->first_row + y][s->first_column / 8];
        const uint8_t *held = &s->second[s->first_row + y][s->first_column / 8];
        if (memcmp(is, held, bytes) != 0) {
            chip_reject(it, "the second memory is not what is shown in row %d", y);
        }
    }
    memcpy(s->shown, s->memory, sizeof s->shown);
    s->partial_refreshes++;
    it->ready_ms = it->now_ms + PARTIAL_MS;
}

/*
 * Clock and analogue on, waveform from its store, drive, all off: a full refresh is 0xF7, one of
 * changes 0xFF.
 */
static void activate(chip *it)
{
    ssd1680 *s = (void *)it;
    if (s->update == 0xFF) {
        show_changes(it);
        return;
    }
    if (s->update != 0xF7) {
        chip_reject(it, "update sequence 0x%02X is not simulated", s->update);
    }
    if ((s->options[0] & 0xF0) != 0x40) {
        chip_reject(it, "the memory of the second colour is shown and was never written");
    }
    memcpy(s->shown, s->memory, sizeof s->shown);
    s->refreshes++;
    it->ready_ms = it->now_ms + REFRESH_MS;
}

static void execute(chip *it)
{
    ssd1680 *s = (void *)it;
    const uint8_t *p = it->parameters;
    switch (it->command) {
    case 0x01:
        s->gates = (p[0] | (p[1] & 1) << 8) + 1;
        if (s->gates > s->last_y + 1 || p[2] != 0) {
            chip_reject(it, "%d gates in order %d", s->gates, p[2]);
        }
        break;
    case 0x10:
        chip_reject(it, "deep sleep is not simulated");
        break;
    case 0x11:
        if (p[0] > 7) {
            chip_reject(it, "entry mode 0x%02X", p[0]);
        }
        s->entry = p[0];
        break;
    case 0x12:
        reset(it);
        break;
    case 0x20:
        activate(it);
        break;
    case 0x21:
        s->options[0] = p[0];
        s->options[1] = p[1];
        break;
    case 0x22:
        s->update = p[0];
        break;
    case 0x24:
    case 0x26:
        s->to_second = it->command == 0x26;
        begin_write(it);
        break;
    case 0x44:
        s->x[0] = p[0];
        s->x[1] = p[1];
        s->counters_set = false;
        break;
    case 0x45:
        s->y[0] = p[0] | p[1] << 8;
        s->y[1] = p[2] | p[3] << 8;
        s->counters_set = false;
        break;
    case 0x4E:
        s->counter_x = p[0];
        break;
    case 0x4F:
        s->counter_y = p[0] | p[1] << 8;
        s->counters_set = true;
        break;
    default:
        break;
    }
}

static void store(chip *it, uint8_t byte)
{
    ssd1680 *s = (void *)it;
    (s->to_second ? s->second : s->memory)[it->window.y][it->window.x] = byte;
    chip_advance(it, (s->entry & Y_FIRST) != 0);
}

static uint32_t pixel(const chip *it, int x, int y)
{
    const ssd1680 *s = (const void *)it;
    if (s->gates != s->height || s->options[1] != s->sources) {
        return 0x808080; /* not driven as the glass is wired */
    }
    int column = s->first_column + x;
    return (s->shown[s->first_row + y][column / 8] >> (7 - column % 8) & 1) != 0 ? 0xFFFFFF : 0;
}

static void init(ssd1680 *s, const chip_model *model, int width, int height)
{
    memset(s->memory, 0xC3, sizeof s->memory);
    memset(s->shown, 0xC3, sizeof s->shown);
    memset(s->second, 0x5A, sizeof s->second); /* whatever it holds */
    s->refreshes = s->partial_refreshes = s->first_column = s->first_row = 0;
    s->width = width;
    s->height = height;
    chip_init(&s->chip, model);
    s->chip.busy_pin = true;
}

void ssd1680_init(ssd1680 *s)
{
    static const chip_model model = CHIP_MODEL("SSD1680", commands, true);
    s->last_x = 21;
    s->last_y = 295;
    s->sources = 0x80;
    init(s, &model, 122, 250);
}

void ssd1681_init(ssd1680 *s)
{
    static const chip_model model = CHIP_MODEL("SSD1681", commands, true);
    s->last_x = 24;
    s->last_y = 199;
    s->sources = 0x00;
    init(s, &model, 200, 200);
}
