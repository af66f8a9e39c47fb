/* SPDX-License-Identifier: MIT */
/*
 * Sharp's memory LCDs: three wires, no commands and no D/C. A transfer is what is sent while SCS is
 * high: a byte of mode, then for each line its number, its pixels and eight clocks for nothing,
 * and eight more at the end. SCS is wired where others have D/C, so that a command, a byte that the
 * display does not see, ends a transfer.
 */
#include "qtri_port/sharp.h"

#include "internal.h"

enum { NOTHING = 0x00, WRITE_LINES = 0x80, VCOM = 0x40, CLEAR = 0x20 };

static const qtri_panel_step init[] = {
    QTRI_STEP(NOTHING, 0, CLEAR, 0x00), /* all white */
    QTRI_STEP_ALONE(NOTHING, 0),
};

static const qtri_panel_step refresh[] = {QTRI_STEP_ALONE(NOTHING, 0)};

/* Bit 0 of a line's number is sent first, and bit 7 of a byte. */
static uint8_t reversed(uint32_t line)
{
    uint32_t result = 0;
    for (int32_t i = 0; i < 8; i++) {
        result = result << 1 | (line >> i & 1);
    }
    return (uint8_t)result;
}

/* One line, from 1 on. The mode of all but the first is the eight clocks after the line before. */
static enum qtri_error window(const qtri_panel *panel, const qtri_rect *bytes)
{
    const uint8_t begin[2] = {(uint8_t)(WRITE_LINES | (panel->polarity ? VCOM : 0)),
                              reversed((uint32_t)bytes->y0 + 1)};
    const qtri_bus *bus = panel->bus;
    return bus->data(bus->context, begin, 2) ? QTRI_OK : QTRI_ERROR_BUS;
}

/* VCOM changes sides each time, as the glass wants without a clock on EXTCOMIN. The first command
   ends what an error may have left open. */
static enum qtri_error write(qtri_panel *panel, const qtri_surface *surface, qtri_rect rect)
{
    static const uint8_t end[2] = {0x00, 0x00};
    const qtri_bus *bus = panel->bus;
    panel->polarity = !panel->polarity;
    enum qtri_error error = qtri_panel_command(panel, NOTHING, NULL, 0);
    error = error == QTRI_OK ? qtri_panel_write_gray(panel, surface, rect) : error;
    error = error == QTRI_OK ? qtri_panel_finish(panel) : error;
    if (error == QTRI_OK && !bus->data(bus->context, end, 2)) {
        error = QTRI_ERROR_BUS;
    }
    return error == QTRI_OK ? qtri_panel_command(panel, NOTHING, NULL, 0) : error;
}

#define SHARP(columns, rows)                                                                       \
    {                                                                                              \
        .width = (columns), .height = (rows), .format = QTRI_PANEL_GRAY1, .init = init,            \
        .init_count = sizeof init / sizeof init[0], .refresh = refresh,                            \
        .refresh_count = sizeof refresh / sizeof refresh[0], .parameters_are_data = true,          \
        .reset_ms = 1, .start_ms = 1, .memory_width = (columns), .memory_height = (rows),          \
        .window = window, .write = write, .window_is_row = true, .window_mask = 255                \
    }

const qtri_panel_description qtri_sharp_96x96 = SHARP(96, 96);
const qtri_panel_description qtri_sharp_128x128 = SHARP(128, 128);
const qtri_panel_description qtri_sharp_144x168 = SHARP(144, 168);
const qtri_panel_description qtri_sharp_400x240 = SHARP(400, 240);
