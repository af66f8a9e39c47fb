/* SPDX-License-Identifier: MIT */
/*
 * SSD1309: OLED of 128x64 pixels, one bit each, over SPI, or I2C with i2c.h: modules of 2.42 inch.
 * An SSD1306 without its charge pump: the module makes the higher voltage.
 */
#ifndef QTRI_PORT_SSD1309_H
#define QTRI_PORT_SSD1309_H

#include "panel.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The panel of 128x64. */
extern const qtri_panel_description qtri_ssd1309;

/* Memory for bands and rectangles of any shape: 1024 bytes. */
#define QTRI_SSD1309_BYTES QTRI_PANEL_IMAGE_BYTES(128, 64, QTRI_PANEL_GRAY1_PAGE)

#ifdef __cplusplus
}
#endif

#endif
