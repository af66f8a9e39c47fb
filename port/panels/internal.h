/* SPDX-License-Identifier: MIT */
/* What the files of this folder share. */
#ifndef QTRI_PANELS_INTERNAL_H
#define QTRI_PANELS_INTERNAL_H

#include "qtri_port/panel.h"

/* One command; parameters with D/C as the description says. */
enum qtri_error qtri_panel_command(const qtri_panel *panel, uint8_t command,
                                   const uint8_t *parameters, uint8_t count);

/* Pixels; by DMA where the bus has it, and then they stay untouched until qtri_panel_finish. */
enum qtri_error qtri_panel_data(qtri_panel *panel, const uint8_t *bytes, size_t count);

/* A rectangle of the frame on the glass, and back. */
qtri_rect qtri_panel_to_glass(const qtri_panel *panel, qtri_rect rect);
qtri_rect qtri_panel_from_glass(const qtri_panel *panel, qtri_rect rect);

/* Where pixel (0, y) of the frame lies on the glass, and the way to the next of its row. */
typedef struct qtri_walk {
    int32_t x, y, dx, dy;
} qtri_walk;
qtri_walk qtri_panel_walk(const qtri_panel *panel, int32_t y);

/*
 * Whether the surface's pixels are those of a display of 16 bits, as uint16_t or with the bytes
 * exchanged. Known by the function that decodes them: the description's address would link all that
 * belongs to it.
 */
bool qtri_panel_is_565(const qtri_surface *surface);
bool qtri_panel_is_swapped_565(const qtri_surface *surface);

enum { QTRI_PANEL_PIECE = 32 }; /* the most pixels that are converted at a time */

/* Pixels (x, y) .. (x + count - 1, y) in the format of the display; the surface holds them all. */
void qtri_panel_row_565(const qtri_panel *panel, const qtri_surface *surface, int32_t x, int32_t y,
                        int32_t count, uint16_t *pixels);
void qtri_panel_row_8888(const qtri_surface *surface, int32_t x, int32_t y, int32_t count,
                         uint32_t *pixels);

/* Big-endian machines store a uint16_t as QTRI_ORDER_BIG does. */
bool qtri_panel_is_native(qtri_byte_order order);

/* Whether the surface lies in memory as an RGB565 display of that order wants it. */
bool qtri_panel_is_in_place(const qtri_surface *surface, qtri_byte_order order);

/* The description's window, when what DMA sends has arrived. */
enum qtri_error qtri_panel_open(qtri_panel *panel, const qtri_rect *bytes);

/* Controllers with MIPI's display command set: bits of its address mode, and its window. */
enum qtri_error qtri_panel_mipi_window(const qtri_panel *panel, const qtri_rect *window);
#define QTRI_MIPI_RED_BLUE 0x08
#define QTRI_MIPI_COLUMNS  0x40
#define QTRI_MIPI_ROWS     0x80

/* What the descriptions of those on a bus of 16 bits a pixel have in common. Glass and memory:
   width, height, not rotated; column, row: where the glass begins. */
#define QTRI_MIPI(glass_w, glass_h, memory_w, memory_h, column, row, steps)                        \
    .width = (glass_w), .height = (glass_h), .format = QTRI_PANEL_RGB565, .order = QTRI_ORDER_BIG, \
    .init = (steps), .init_count = sizeof(steps) / sizeof(steps)[0], .parameters_are_data = true,  \
    .reset_ms = 1, .start_ms = 120, .orientation_command = 0x36, .rows_bit = QTRI_MIPI_ROWS,       \
    .columns_bit = QTRI_MIPI_COLUMNS, .red_blue_bit = QTRI_MIPI_RED_BLUE,                          \
    .memory_width = (memory_w), .memory_height = (memory_h), .first_column = (column),             \
    .first_row = (row), .window = qtri_panel_mipi_window, .write = qtri_panel_write_565,           \
    .invert_commands = {0x20, 0x21}

/* Solomon's OLED controllers: ranges of columns, command 0x15, and rows, 0x75, half-open, in the
   controller's units; and the window of those whose column is a byte, two pixels. */
enum qtri_error qtri_panel_solomon_ranges(const qtri_panel *panel, const qtri_rect *range);
enum qtri_error qtri_panel_solomon_window(const qtri_panel *panel, const qtri_rect *bytes);

#endif
