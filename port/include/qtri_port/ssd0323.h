/* SPDX-License-Identifier: MIT */
/*
 * SSD0323: OLED of 128x64 pixels, 16 levels of gray, over SPI. The wiring is that of OSRAM's
 * Pictiva module on Luminary's LM3S boards. Command parameters go with D/C low.
 */
#ifndef QTRI_PORT_SSD0323_H
#define QTRI_PORT_SSD0323_H

#include "panel.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The panel of 128x64, 16 grays. */
extern const qtri_panel_description qtri_ssd0323;

/* Memory for bands and rectangles of any shape: 4096 bytes. Unrotated or turned by 180 degrees, a
   row, 64 bytes, is enough for anything. */
#define QTRI_SSD0323_BYTES     QTRI_PANEL_IMAGE_BYTES(128, 64, QTRI_PANEL_GRAY4)
#define QTRI_SSD0323_ROW_BYTES QTRI_PANEL_ROW_BYTES(128, QTRI_PANEL_GRAY4)

#ifdef __cplusplus
}
#endif

#endif
