/* SPDX-License-Identifier: MIT */
/*
 * SSD1327: OLED of 128x128 pixels, 16 levels of gray, over SPI, or I2C with i2c.h: modules of 1.5
 * inch. Command parameters go with D/C low.
 */
#ifndef QTRI_PORT_SSD1327_H
#define QTRI_PORT_SSD1327_H

#include "panel.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The panel of 128x128, 16 grays. */
extern const qtri_panel_description qtri_ssd1327;

/* Memory for bands and rectangles of any shape: 8192 bytes. Unrotated or turned by 180 degrees, a
   row, 64 bytes, is enough for anything. */
#define QTRI_SSD1327_BYTES     QTRI_PANEL_IMAGE_BYTES(128, 128, QTRI_PANEL_GRAY4)
#define QTRI_SSD1327_ROW_BYTES QTRI_PANEL_ROW_BYTES(128, QTRI_PANEL_GRAY4)

#ifdef __cplusplus
}
#endif

#endif
