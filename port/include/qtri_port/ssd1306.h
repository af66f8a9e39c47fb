/* SPDX-License-Identifier: MIT */
/*
 * SSD1306: OLED of 128x64 pixels, one bit each, over SPI, or I2C with i2c.h at address 0x3C or
 * 0x3D. With its charge pump on: modules that run from one voltage.
 */
#ifndef QTRI_PORT_SSD1306_H
#define QTRI_PORT_SSD1306_H

#include "panel.h"

#ifdef __cplusplus
extern "C" {
#endif

extern const qtri_panel_description qtri_ssd1306;        /* 128x64 */
extern const qtri_panel_description qtri_ssd1306_128x32; /* 128x32 */
extern const qtri_panel_description qtri_ssd1306_72x40;  /* 0.42 inch, from column 28 */

/* Memory for bands and rectangles of any shape: 1024 bytes. */
#define QTRI_SSD1306_BYTES QTRI_PANEL_IMAGE_BYTES(128, 64, QTRI_PANEL_GRAY1_PAGE)

#ifdef __cplusplus
}
#endif

#endif
