/* SPDX-License-Identifier: MIT */
/*
 * Displays that say when they have shown a picture to its end, on a pin that is called TE: who
 * begins to send then, and sends no slower than the display reads, never shows halves of two
 * frames.
 *
 *     qtri_tearing_on(&panel);
 *     for (;;) {
 *         qtri_tearing_wait(&panel, te_is_high, 1000000);
 *         draw and write the bands of a frame;
 *     }
 */
#ifndef QTRI_PORT_TEARING_H
#define QTRI_PORT_TEARING_H

#include "panel.h"

#ifdef __cplusplus
extern "C" {
#endif

/*
 * Switches the pin of a controller with MIPI's commands on (0x35), high between two pictures:
 * ILI9341, ST7789, ST7735, GC9A01. QTRI_ERROR_SIZE for other panels, which get no command.
 */
enum qtri_error qtri_tearing_on(qtri_panel *panel);

/*
 * Waits until everything is sent, and then until the pin rises: `is_high` reads it, with the
 * context of the panel's bus (NULL without a bus), at most most_reads times. QTRI_ERROR_BUS: it did
 * not rise, or sending failed.
 */
enum qtri_error qtri_tearing_wait(qtri_panel *panel, bool (*is_high)(void *context),
                                  uint32_t most_reads);

#ifdef __cplusplus
}
#endif

#endif
