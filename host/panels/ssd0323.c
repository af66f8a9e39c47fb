/* SPDX-License-Identifier: MIT */
#include "controllers.h"

#include <string.h>

/* The command table, without the graphic acceleration commands 0x23..0x2F. */
static const chip_command ssd0323_commands[] = {
    {0x15, 0x15, 2}, {0x75, 0x75, 2}, {0x81, 0x81, 1}, {0x84, 0x86, 0}, {0xA0, 0xA2, 1},
    {0xA4, 0xA7, 0}, {0xA8, 0xA8, 1}, {0xAD, 0xAD, 1}, {0xAE, 0xAF, 0}, {0xB0, 0xB4, 1},
    {0xB8, 0xB8, 8}, {0xBC, 0xBC, 1}, {0xBE, 0xBF, 1}, {0xE3, 0xE3, 0},
};

static const chip_command ssd1327_commands[] = {
    {0x15, 0x15, 2}, {0x75, 0x75, 2},  {0x81, 0x81, 1}, {0xA0, 0xA2, 1}, {0xA4, 0xA7, 0},
    {0xA8, 0xA8, 1}, {0xAB, 0xAB, 1},  {0xAE, 0xAF, 0}, {0xB1, 0xB1, 1}, {0xB3, 0xB3, 1},
    {0xB5, 0xB6, 1}, {0xB8, 0xB8, 15}, {0xB9, 0xB9, 0}, {0xBC, 0xBC, 1}, {0xBE, 0xBE, 1},
    {0xD5, 0xD5, 1}, {0xFD, 0xFD, 1},
};

static const chip_command ssd1322_commands[] = {
    {0x00, 0x00, 0},  {0x15, 0x15, 2}, {0x5C, 0x5C, CHIP_STREAM}, {0x75, 0x75, 2}, {0xA0, 0xA0, 2},
    {0xA1, 0xA2, 1},  {0xA4, 0xA7, 0}, {0xA8, 0xA8, 2},           {0xA9, 0xA9, 0}, {0xAB, 0xAB, 1},
    {0xAE, 0xAF, 0},  {0xB1, 0xB1, 1}, {0xB3, 0xB3, 1},           {0xB4, 0xB4, 2}, {0xB5, 0xB6, 1},
    {0xB8, 0xB8, 15}, {0xB9, 0xB9, 0}, {0xBB, 0xBB, 1},           {0xBE, 0xBE, 1}, {0xC1, 0xC1, 1},
    {0xC7, 0xC7, 1},  {0xCA, 0xCA, 1}, {0xD1, 0xD1, 2},           {0xFD, 0xFD, 1},
};

/* What differs between them and the glass they are on. */
struct gray_kind {
    int last_column, last_row, column_bytes; /* of the memory; a column is 1 or 2 bytes */
    int width, height, first_byte;           /* of the glass, and where it begins in a row */
    int remap_bits, columns_bit, halves_bit, down_bit, rows_bit;
    int split_bit, is_split, second; /* of the remap: how the glass's rows are wired */
    int offset;                      /* that brings its first row to the top */
    bool from_last;                  /* the last segment is left */
    int normal, off;                 /* modes of the display */
    bool by_command;                 /* 0x5C begins the data */
};
typedef struct gray_kind gray_kind;

static const gray_kind ssd0323_kind = {63,   79,   1,    128, 64, 0,     0x57, 1,    2,    4,
                                       0x10, 0x40, 0x40, 0,   76, false, 0xA4, 0xA6, false};
static const gray_kind ssd1327_kind = {63,   127,  1,    128, 128, 0,    0x57, 1,    2,    4,
                                       0x10, 0x40, 0x40, 0,   0,   true, 0xA4, 0xA6, false};
static const gray_kind ssd1322_kind = {119,  127,  2, 256,  64, 56,    0x37, 2,    4,   1,
                                       0x10, 0x20, 0, 0x11, 0,  false, 0xA6, 0xA4, true};

static void reset(chip *it)
{
    ssd0323 *s = (void *)it;
    memset(s->memory, 0x5A, sizeof s->memory);
    s->remap = s->offset = s->start_line = s->second = 0;
    s->multiplex = s->kind->last_row;
    s->mode = s->kind->normal;
    s->on = false;
    it->window.x1 = (s->kind->last_column + 1) * s->kind->column_bytes - 1;
    it->window.y1 = s->kind->last_row;
}

/* The window's ends; where a command begins the data they are not taken before. */
static void set_window(chip *it)
{
    const gray_kind *kind = ((const ssd0323 *)(const void *)it)->kind;
    chip_window *w = &it->window;
    const uint8_t *p = it->parameters;
    if (it->command == 0x15) {
        chip_allow_range(it, p[0], p[1], kind->last_column);
        w->x = w->x0 = p[0] * kind->column_bytes;
        w->x1 = (p[1] + 1) * kind->column_bytes - 1;
    } else if (it->command == 0x75) {
        chip_allow_range(it, p[0], p[1], kind->last_row);
        w->y = w->y0 = p[0];
        w->y1 = p[1];
    }
    w->set = !kind->by_command || it->command == 0x5C;
    w->full = false;
}

static void set_remap(chip *it)
{
    ssd0323 *s = (void *)it;
    chip_allow(it, (it->parameters[0] & ~s->kind->remap_bits) == 0);
    s->remap = it->parameters[0];
    s->second = s->kind->second != 0 ? it->parameters[1] : 0;
}

static void execute(chip *it)
{
    ssd0323 *s = (void *)it;
    const uint8_t *p = it->parameters;
    switch (it->command) {
    case 0x15:
    case 0x5C:
    case 0x75:
        set_window(it);
        break;
    case 0x81:
        chip_allow(it, p[0] <= 127 || s->kind != &ssd0323_kind);
        break;
    case 0xA0:
        set_remap(it);
        break;
    case 0xA1:
        chip_allow(it, p[0] <= s->kind->last_row);
        s->start_line = p[0];
        break;
    case 0xA2:
        chip_allow(it, p[0] <= s->kind->last_row);
        s->offset = p[0];
        break;
    case 0xA4:
    case 0xA5:
    case 0xA6:
    case 0xA7:
        s->mode = it->command;
        break;
    case 0xA8: /* of the SSD1322 a partial display */
    case 0xCA:
        chip_allow(it, p[0] >= 15 && p[0] <= s->kind->last_row);
        s->multiplex = p[0];
        break;
    case 0xAD:
        chip_allow(it, (p[0] & ~1) == 2);
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
    ssd0323 *s = (void *)it;
    s->memory[it->window.y][it->window.x] = byte;
    chip_advance(it, (s->remap & s->kind->down_bit) != 0);
}

/*
 * Without remapping, the low half of a column's first byte is its first segment. A column of two
 * bytes keeps its pixels in the opposite order as a whole.
 */
static uint32_t pixel(const chip *it, int x, int y)
{
    const ssd0323 *s = (const void *)it;
    const gray_kind *kind = s->kind;
    if (!s->on || (s->remap & kind->split_bit) != kind->is_split || s->second != kind->second ||
        s->multiplex != kind->height - 1 || s->mode == kind->off) {
        return 0;
    }
    if (s->mode == 0xA5) {
        return 0xFFFFFF;
    }
    const int pixels = 2 * kind->column_bytes; /* of a column */
    const int all = (kind->last_column + 1) * pixels;
    const int segment = kind->from_last ? all - 1 - x : x + 2 * kind->first_byte;
    int column = segment / pixels, within = segment % pixels;
    column = (s->remap & kind->columns_bit) != 0 ? kind->last_column - column : column;
    if ((s->remap & kind->halves_bit) != 0) {
        within = pixels - 1 - within;
    }
    const int byte = kind->column_bytes == 1 ? column : 2 * column + (within < 2 ? 1 : 0);
    const int line = (s->remap & kind->rows_bit) != 0 ? y : kind->height - 1 - y;
    const int rows = kind->last_row + 1;
    const int row = (line + s->start_line + s->offset - kind->offset + rows + s->first_row) % rows;
    const int level = within % 2 != 0 ? s->memory[row][byte] >> 4 : s->memory[row][byte] & 15;
    return (uint32_t)(s->mode == 0xA7 ? 15 - level : level) * 0x111111;
}

static void init(ssd0323 *s, const gray_kind *kind, const chip_model *model)
{
    s->kind = kind;
    s->first_row = 0;
    chip_init(&s->chip, model);
}

void ssd0323_init(ssd0323 *s)
{
    static const chip_model model = CHIP_MODEL("SSD0323", ssd0323_commands, false);
    init(s, &ssd0323_kind, &model);
}

void ssd1327_init(ssd0323 *s)
{
    static const chip_model model = CHIP_MODEL("SSD1327", ssd1327_commands, false);
    init(s, &ssd1327_kind, &model);
}

void ssd1322_init(ssd0323 *s)
{
    static const chip_model model = CHIP_MODEL("SSD1322", ssd1322_commands, true);
    init(s, &ssd1322_kind, &model);
}
