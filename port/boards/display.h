/* SPDX-License-Identifier: MIT */
/*
 * What a board with a display has besides board.h.
 */
#ifndef QTRI_BOARD_DISPLAY_H
#define QTRI_BOARD_DISPLAY_H

#include "qtri_port/panel.h"

/* Switches the display on; panel is then ready for qtri_panel_write. */
enum qtri_error board_display_init(qtri_panel *panel);

/* Waits until somebody sends a byte to the console. */
void board_wait_for_key(void);

#endif
