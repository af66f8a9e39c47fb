/* SPDX-License-Identifier: MIT */
/*
 * What the examples ask of what they run on: two functions. board.c has them for the emulated
 * boards, display.c and host.c for this computer; for a board of one's own they are a dozen lines,
 * see README.md.
 */
#ifndef QTRI_EXAMPLE_H
#define QTRI_EXAMPLE_H

#include <stdbool.h>

#include "qtri_port/panel.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Switches the display on; the panel is then ready for qtri_panel_write. */
enum qtri_error example_display(qtri_panel *panel);

/*
 * After each frame: waits until the display has it and the next one is due. False: the example is
 * to end, which it never is on a real board.
 */
bool example_next_frame(qtri_panel *panel);

/* The example itself. QTRI_OK when it was to end; otherwise what went wrong. */
enum qtri_error example_run(void);
extern const char example_name[];

#ifdef __cplusplus
}
#endif

#endif
