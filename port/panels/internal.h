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

/* Pixels (x, y) .. (x + count - 1, y) in the format of the display; the surface holds them all. */
void qtri_panel_row_565(const qtri_surface *surface, int32_t x, int32_t y, int32_t count,
                        uint16_t *pixels);
void qtri_panel_row_8888(const qtri_surface *surface, int32_t x, int32_t y, int32_t count,
                         uint32_t *pixels);

/* Big-endian machines store a uint16_t as QTRI_ORDER_BIG does. */
bool qtri_panel_is_native(qtri_byte_order order);

/* Whether the surface lies in memory as an RGB565 display of that order wants it. */
bool qtri_panel_is_in_place(const qtri_surface *surface, qtri_byte_order order);

/* The three ways to a display: rect is part of the frame and of the surface, and not empty. */
enum qtri_error qtri_panel_stream(qtri_panel *panel, const qtri_surface *surface, qtri_rect rect);
enum qtri_error qtri_panel_packed(qtri_panel *panel, const qtri_surface *surface, qtri_rect rect);
void qtri_panel_store(const qtri_panel *panel, const qtri_surface *surface, qtri_rect rect);

/* The description's window, when what DMA sends has arrived. */
enum qtri_error qtri_panel_open(qtri_panel *panel, const qtri_rect *bytes);

/* Windows of the families of controllers. */
enum qtri_error qtri_panel_mipi_window(const qtri_panel *panel, const qtri_rect *window);

#endif
