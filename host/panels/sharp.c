/* SPDX-License-Identifier: MIT */
/* Memory LCDs of Sharp's, LS013B7DH03 and LS027B7DH01: what arrives while SCS, here D/C, is high.
 */
#include "controllers.h"

#include <string.h>

enum { MODE, ADDRESS, PIXELS, BETWEEN, CLEARING };
enum { WRITES = 0x80, VCOM = 0x40, CLEARS = 0x20 };

/* A byte while SCS is low is not seen, and ends what was under way. */
static const chip_command commands[] = {{0x00, 0xFF, CHIP_STREAM}};

static void reset(chip *it)
{
    sharp_lcd *s = (void *)it;
    memset(s->memory, 0x5A, sizeof s->memory);
    s->state = MODE;
    s->dirty = false;
    s->vcom = s->vcom_changes = s->have = 0;
}

static void execute(chip *it)
{
    sharp_lcd *s = (void *)it;
    if (s->dirty) {
        chip_reject(it, "line %d ends without clocks after it", s->line);
    } else if (s->state == ADDRESS || s->state == PIXELS) {
        chip_reject(it, "SCS falls in the middle of line %d", s->line);
    }
    s->state = MODE;
    it->window.set = true;
}

static void set_mode(chip *it, uint8_t byte)
{
    sharp_lcd *s = (void *)it;
    const int vcom = (byte & VCOM) != 0;
    s->vcom_changes += vcom != s->vcom;
    s->vcom = vcom;
    if ((byte & 0x1F) != 0 || (byte & (WRITES | CLEARS)) == (WRITES | CLEARS)) {
        chip_reject(it, "mode 0x%02X", byte);
    }
    s->have = 0;
    s->state = (byte & WRITES) != 0 ? ADDRESS : CLEARING;
    if ((byte & CLEARS) != 0) {
        memset(s->memory, 0xFF, sizeof s->memory);
    }
}

/* Bit 0 comes first, in bit 7. */
static void set_line(chip *it, uint8_t byte)
{
    sharp_lcd *s = (void *)it;
    s->line = 0;
    for (int i = 0; i < 8; i++) {
        s->line |= (byte >> (7 - i) & 1) << i;
    }
    if (s->line < 1 || s->line > s->height) {
        chip_reject(it, "line %d of 1..%d", s->line, s->height);
        s->line = 1;
    }
    s->have = 0;
    s->state = PIXELS;
}

static void store(chip *it, uint8_t byte)
{
    sharp_lcd *s = (void *)it;
    switch (s->state) {
    case MODE:
        set_mode(it, byte);
        break;
    case ADDRESS:
        s->dirty = false;
        if (byte == 0 && s->have != 0) { /* the last eight clocks */
            s->state = CLEARING;
        } else {
            set_line(it, byte);
        }
        break;
    case PIXELS:
        s->latch[s->have++] = byte;
        if (s->have == (s->width + 7) / 8) {
            s->dirty = true;
            s->state = BETWEEN;
        }
        break;
    case BETWEEN: /* eight clocks bring the line from the latch to the glass */
        memcpy(s->memory[s->line - 1], s->latch, (size_t)s->have);
        s->state = ADDRESS;
        break;
    default: /* clocks for nothing */
        break;
    }
}

static uint32_t pixel(const chip *it, int x, int y)
{
    const sharp_lcd *s = (const void *)it;
    return (s->memory[y][x / 8] >> (7 - x % 8) & 1) != 0 ? 0xFFFFFF : 0;
}

void sharp_init(sharp_lcd *s, int width, int height)
{
    static const chip_model model = CHIP_MODEL("memory LCD", commands, true);
    s->width = width;
    s->height = height;
    s->line = 0;
    chip_init(&s->chip, &model);
}
