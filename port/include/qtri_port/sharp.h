/* SPDX-License-Identifier: MIT */
/*
 * Sharp's memory LCDs, LS013B7DH03 (128x128), LS027B7DH01 (400x240) and their like: one bit a
 * pixel, SPI of 2 MHz at most, no D/C and no reset. Wire the display's SCS where others have D/C:
 * it is high while data are sent. Its DISP may be the bus's reset pin. White after init.
 *
 * The glass wants its VCOM exchanged once a second at least. It is with every qtri_panel_write and
 * qtri_panel_write_rect: send a row where nothing else changes; or wire a clock of 1 to 60 Hz to
 * EXTCOMIN, and EXTMODE to the supply.
 */
#ifndef QTRI_PORT_SHARP_H
#define QTRI_PORT_SHARP_H

#include "panel.h"

#ifdef __cplusplus
extern "C" {
#endif

extern const qtri_panel_description qtri_sharp_96x96;   /* LS013B4DN04, 1.35 inch */
extern const qtri_panel_description qtri_sharp_128x128; /* LS013B7DH03, 1.28 inch */
extern const qtri_panel_description qtri_sharp_144x168; /* LS013B7DH05, 1.26 inch */
extern const qtri_panel_description qtri_sharp_400x240; /* LS027B7DH01, 2.7 inch */

#ifdef __cplusplus
}
#endif

#endif
