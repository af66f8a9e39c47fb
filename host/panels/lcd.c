/* SPDX-License-Identifier: MIT */
#include "controllers.h"

#include <string.h>

/* What all of them know: MIPI's display command set. Reading commands are left out. */
#define MIPI_COMMANDS                                                                              \
    {0x00, 0x01, 0}, {0x10, 0x13, 0}, {0x20, 0x21, 0}, {0x26, 0x26, 1}, {0x28, 0x29, 0},           \
        {0x2A, 0x2B, 4}, {0x2C, 0x2C, CHIP_STREAM}, {0x30, 0x30, 4}, {0x33, 0x33, 6},              \
        {0x34, 0x34, 0}, {0x35, 0x36, 1}, {0x37, 0x37, 2}, {0x38, 0x39, 0}, {0x3A, 0x3A, 1},       \
        {0x3C, 0x3C, CHIP_STREAM}, {0x44, 0x44, 2}, {0x51, 0x51, 1}, {0x53, 0x53, 1},              \
        {0x55, 0x55, 1},                                                                           \
    {                                                                                              \
        0x5E, 0x5E, 1                                                                              \
    }

static const chip_command ili9341_commands[] = {
    MIPI_COMMANDS,   {0xB0, 0xB0, 1},  {0xB1, 0xB3, 2}, {0xB4, 0xB4, 1}, {0xB5, 0xB6, 4},
    {0xB7, 0xB7, 1}, {0xC0, 0xC1, 1},  {0xC5, 0xC5, 2}, {0xC7, 0xC7, 1}, {0xCB, 0xCB, 5},
    {0xCF, 0xCF, 3}, {0xE0, 0xE1, 15}, {0xE8, 0xE8, 3}, {0xEA, 0xEA, 2}, {0xED, 0xED, 4},
    {0xF2, 0xF2, 1}, {0xF6, 0xF6, 3},  {0xF7, 0xF7, 1},
};

static const chip_command st7789_commands[] = {
    MIPI_COMMANDS,   {0xB0, 0xB0, 2}, {0xB1, 0xB1, 3}, {0xB2, 0xB2, 5},
    {0xB7, 0xB7, 1}, {0xBB, 0xBB, 1}, {0xC0, 0xC0, 1}, {0xC2, 0xC2, 2},
    {0xC3, 0xC4, 1}, {0xC6, 0xC6, 1}, {0xD0, 0xD0, 2}, {0xE0, 0xE1, 14},
};

static const chip_command st7735_commands[] = {
    MIPI_COMMANDS,   {0xB1, 0xB2, 3}, {0xB3, 0xB3, 6},  {0xB4, 0xB4, 1},
    {0xB6, 0xB6, 2}, {0xC0, 0xC0, 3}, {0xC1, 0xC1, 1},  {0xC2, 0xC4, 2},
    {0xC5, 0xC5, 1}, {0xC7, 0xC7, 1}, {0xE0, 0xE1, 16}, {0xFC, 0xFC, 1},
};

/* Those without a name by the numbers of parameters that they come with. */
static const chip_command gc9a01_commands[] = {
    MIPI_COMMANDS,   {0x62, 0x63, 12}, {0x64, 0x64, 7}, {0x66, 0x67, 10}, {0x70, 0x70, 9},
    {0x74, 0x74, 7}, {0x84, 0x8F, 1},  {0x90, 0x90, 4}, {0x98, 0x98, 2},  {0xAE, 0xAE, 1},
    {0xB5, 0xB5, 3}, {0xB6, 0xB6, 2},  {0xBA, 0xBA, 1}, {0xBC, 0xBE, 1},  {0xC1, 0xC1, 1},
    {0xC3, 0xC4, 1}, {0xC9, 0xC9, 1},  {0xCD, 0xCD, 1}, {0xDF, 0xDF, 3},  {0xE1, 0xE1, 2},
    {0xE8, 0xE8, 1}, {0xEB, 0xEB, 1},  {0xED, 0xED, 2}, {0xEF, 0xEF, 0},  {0xF0, 0xF3, 6},
    {0xFE, 0xFE, 0}, {0xFF, 0xFF, 3},
};

static const chip_command ili9342_commands[] = {
    MIPI_COMMANDS,   {0xB0, 0xB0, 1}, {0xB1, 0xB3, 2},  {0xB4, 0xB4, 1},
    {0xB5, 0xB6, 4}, {0xB7, 0xB7, 1}, {0xC0, 0xC0, 2},  {0xC1, 0xC1, 1},
    {0xC5, 0xC5, 1}, {0xC8, 0xC8, 3}, {0xE0, 0xE1, 15}, {0xF6, 0xF6, 3},
};

static const chip_command ili9488_commands[] = {
    MIPI_COMMANDS,    {0xB0, 0xB0, 1}, {0xB1, 0xB3, 1}, {0xB4, 0xB4, 1}, {0xB5, 0xB5, 4},
    {0xB6, 0xB6, 3},  {0xB7, 0xB7, 1}, {0xC0, 0xC0, 2}, {0xC1, 0xC1, 1}, {0xC5, 0xC5, 3},
    {0xE0, 0xE1, 15}, {0xE9, 0xE9, 1}, {0xF7, 0xF7, 4},
};

static const chip_command st7796_commands[] = {
    MIPI_COMMANDS,    {0xB0, 0xB0, 1}, {0xB1, 0xB3, 2}, {0xB4, 0xB4, 1}, {0xB5, 0xB5, 4},
    {0xB6, 0xB6, 3},  {0xB7, 0xB7, 1}, {0xC0, 0xC0, 2}, {0xC1, 0xC2, 1}, {0xC5, 0xC5, 1},
    {0xE0, 0xE1, 14}, {0xE8, 0xE8, 8}, {0xF0, 0xF0, 1},
};

enum { ROWS_REVERSED = 0x80, COLUMNS_REVERSED = 0x40, EXCHANGED = 0x20, BLUE_FIRST = 0x08 };

/* Registers as after power on; 5 ms pass before commands, 120 ms before the chip may be woken. */
static void reset(chip *it)
{
    lcd *s = (void *)it;
    s->address_mode = 0;
    s->pixel_format = 0x66;
    s->columns[0] = s->pages[0] = 0;
    s->columns[1] = s->width - 1;
    s->pages[1] = s->height - 1;
    s->on = s->awake = s->inverted = s->extended = false;
    s->have = s->opened = 0;
    it->ready_ms = it->now_ms + 5;
    s->wake_ms = it->now_ms + 120;
}

/* The window is looked at when writing starts, in the directions of the address mode. */
static void begin_write(chip *it)
{
    lcd *s = (void *)it;
    bool exchanged = (s->address_mode & EXCHANGED) != 0;
    int last_column = exchanged ? s->height - 1 : s->width - 1;
    int last_page = exchanged ? s->width - 1 : s->height - 1;
    if (s->columns[0] > s->columns[1] || s->columns[1] > last_column) {
        chip_reject(it, "columns %d..%d of 0..%d", s->columns[0], s->columns[1], last_column);
    }
    if (s->pages[0] > s->pages[1] || s->pages[1] > last_page) {
        chip_reject(it, "pages %d..%d of 0..%d", s->pages[0], s->pages[1], last_page);
    }
    const bool is_18 = s->pixel_format == 0x66 && s->bytes == 3; /* the bits for the bus */
    const bool is_16 = (s->pixel_format == 0x55 || s->pixel_format == 0x05) && s->bytes == 2;
    if (!is_18 && !is_16) {
        chip_reject(it, "data in pixel format 0x%02X, only %d bits are simulated", s->pixel_format,
                    s->bytes == 3 ? 18 : 16);
    }
    chip_open_window(it, s->columns, s->pages, s->columns[0], s->pages[0]);
    s->have = 0;
}

static void set_range(chip *it, int range[2])
{
    const lcd *s = (const void *)it;
    const uint8_t *p = it->parameters;
    range[0] = p[0] << 8 | p[1];
    range[1] = p[2] << 8 | p[3];
    chip_allow_range(it, range[0], range[1], (s->width > s->height ? s->width : s->height) - 1);
}

static void execute(chip *it)
{
    lcd *s = (void *)it;
    if (s->have != 0) {
        chip_reject(it, "command 0x%02X in the middle of a pixel", it->command);
    }
    if (s->locked && !s->extended && it->command >= 0xB0 && it->command != 0xF0 &&
        it->command != 0xC8) {
        chip_reject(it, "command 0x%02X is locked", it->command);
    }
    switch (it->command) {
    case 0x01:
        reset(it);
        break;
    case 0x10:
        s->awake = false;
        it->ready_ms = it->now_ms + 5;
        break;
    case 0x11:
        if (it->now_ms < s->wake_ms) {
            chip_reject(it, "woken %d ms too early", (int)(s->wake_ms - it->now_ms));
        }
        s->awake = true;
        it->ready_ms = it->now_ms + 5;
        break;
    case 0x20:
    case 0x21:
        s->inverted = it->command == 0x21;
        break;
    case 0x26: /* one bit */
        if (it->parameters[0] == 0 || (it->parameters[0] & ~15) != 0 ||
            (it->parameters[0] & (it->parameters[0] - 1)) != 0) {
            chip_reject(it, "gamma curve 0x%02X", it->parameters[0]);
        }
        break;
    case 0x28:
    case 0x29:
        s->on = it->command == 0x29;
        break;
    case 0x2A:
        set_range(it, s->columns);
        break;
    case 0x2B:
        set_range(it, s->pages);
        break;
    case 0x2C:
        begin_write(it);
        break;
    case 0x36:
        if ((it->parameters[0] & 3) != 0) {
            chip_reject(it, "address mode 0x%02X", it->parameters[0]);
        }
        s->address_mode = it->parameters[0];
        it->window.set = false;
        break;
    case 0x3A:
        s->pixel_format = it->parameters[0];
        break;
    case 0xF0: /* ST7796: two numbers open the manufacturer's commands */
        s->extended = it->parameters[0] == 0x96 && s->opened == 0xC3;
        s->opened = it->parameters[0];
        break;
    case 0xC8: /* ILI9342: three do */
        s->extended =
            it->parameters[0] == 0xFF && it->parameters[1] == 0x93 && it->parameters[2] == 0x42;
        break;
    default:
        break;
    }
}

static void store(chip *it, uint8_t byte)
{
    lcd *s = (void *)it;
    s->part = s->part << 8 | byte;
    if (++s->have < s->bytes) {
        return;
    }
    s->have = 0;
    bool exchanged = (s->address_mode & EXCHANGED) != 0;
    int column = exchanged ? it->window.y : it->window.x;
    int row = exchanged ? it->window.x : it->window.y;
    column = (s->address_mode & COLUMNS_REVERSED) != 0 ? s->width - 1 - column : column;
    row = (s->address_mode & ROWS_REVERSED) != 0 ? s->height - 1 - row : row;
    s->memory[row][column] = s->part & (s->bytes == 3 ? 0xFFFFFF : 0xFFFF);
    chip_advance(it, false);
}

uint32_t lcd_widened(uint32_t value, uint32_t max)
{
    return (value * 255 + max / 2) / max;
}

uint32_t lcd_glass_shows(const lcd_glass *glass, uint32_t first, uint32_t green, uint32_t last,
                         bool swapped, bool inverted)
{
    const uint32_t seen =
        swapped ? last << 16 | green << 8 | first : first << 16 | green << 8 | last;
    return inverted != glass->normally_black ? ~seen & 0xFFFFFF : seen;
}

static uint32_t pixel(const chip *it, int x, int y)
{
    const lcd *s = (const void *)it;
    const lcd_glass *g = &s->glass;
    if (!s->on || !s->awake) {
        return 0;
    }
    int across = g->columns_from_right ? g->width - 1 - x : x;
    int down = g->rows_from_bottom ? g->height - 1 - y : y;
    uint32_t c = s->memory[g->first_row + down][g->first_column + across];
    uint32_t first = s->bytes == 3 ? lcd_widened(c >> 18, 63) : lcd_widened(c >> 11, 31);
    uint32_t green = lcd_widened(s->bytes == 3 ? c >> 10 & 63 : c >> 5 & 63, 63);
    uint32_t last = s->bytes == 3 ? lcd_widened(c >> 2 & 63, 63) : lcd_widened(c & 31, 31);
    const bool swapped = ((s->address_mode & BLUE_FIRST) != 0) != g->blue_first;
    return lcd_glass_shows(g, first, green, last, swapped, s->inverted);
}

static void init(lcd *s, const chip_model *model, const lcd_glass *glass, int width, int height)
{
    s->glass = *glass;
    s->width = width;
    s->height = height;
    s->bytes = 2;
    s->locked = false;
    memset(s->memory, 0x5A, sizeof s->memory);
    chip_init(&s->chip, model);
}

void ili9341_init(lcd *s)
{
    static const lcd_glass glass = {240, 320, 0, 0, true, true, false, false};
    static const chip_model model = CHIP_MODEL("ILI9341", ili9341_commands, true);
    init(s, &model, &glass, 240, 320);
}

void st7789_init(lcd *s, const lcd_glass *glass)
{
    static const chip_model model = CHIP_MODEL("ST7789", st7789_commands, true);
    init(s, &model, glass, 240, 320);
}

void st7735_init(lcd *s, const lcd_glass *glass, int width, int height)
{
    static const chip_model model = CHIP_MODEL("ST7735", st7735_commands, true);
    init(s, &model, glass, width, height);
}

void gc9a01_init(lcd *s, const lcd_glass *glass)
{
    static const chip_model model = CHIP_MODEL("GC9A01", gc9a01_commands, true);
    init(s, &model, glass, 240, 240);
}

void ili9342_init(lcd *s, const lcd_glass *glass)
{
    static const chip_model model = CHIP_MODEL("ILI9342", ili9342_commands, true);
    init(s, &model, glass, 320, 240);
    s->locked = true;
}

void ili9488_init(lcd *s, const lcd_glass *glass)
{
    static const chip_model model = CHIP_MODEL("ILI9488", ili9488_commands, true);
    init(s, &model, glass, 320, 480);
    s->bytes = 3; /* its SPI takes no others */
}

void st7796_init(lcd *s, const lcd_glass *glass)
{
    static const chip_model model = CHIP_MODEL("ST7796", st7796_commands, true);
    init(s, &model, glass, 320, 480);
    s->locked = true;
}
