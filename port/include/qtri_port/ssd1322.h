/* SPDX-License-Identifier: MIT */
/*
 * SSD1322: OLED of 256x64 pixels, 16 levels of gray, over SPI: modules of 2.8 to 3.2 inch, whose
 * jumpers must say 4-wire SPI. Its windows are four pixels wide and more.
 */
#ifndef QTRI_PORT_SSD1322_H
#define QTRI_PORT_SSD1322_H

#include "panel.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The panel of 256x64, 16 grays. */
extern const qtri_panel_description qtri_ssd1322;

/* Memory for bands and rectangles of any shape: 8192 bytes. Unrotated or turned by 180 degrees, a
   row, 128 bytes, is enough for anything. */
#define QTRI_SSD1322_BYTES     QTRI_PANEL_IMAGE_BYTES(256, 64, QTRI_PANEL_GRAY4)
#define QTRI_SSD1322_ROW_BYTES QTRI_PANEL_ROW_BYTES(256, QTRI_PANEL_GRAY4)

#ifdef __cplusplus
}
#endif

#endif
