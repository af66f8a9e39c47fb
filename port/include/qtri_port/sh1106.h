/* SPDX-License-Identifier: MIT */
/*
 * SH1106: OLED of 128x64 pixels, one bit each, over SPI, or I2C with i2c.h at address 0x3C or 0x3D.
 * Modules of 1.3 inch, mostly, often sold as SSD1306, whose picture is shifted by two columns there
 * and has other commands: the memory is addressed page by page.
 */
#ifndef QTRI_PORT_SH1106_H
#define QTRI_PORT_SH1106_H

#include "panel.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The panel of 128x64. */
extern const qtri_panel_description qtri_sh1106;

/* Memory for bands and rectangles of any shape: 1024 bytes. */
#define QTRI_SH1106_BYTES QTRI_PANEL_IMAGE_BYTES(128, 64, QTRI_PANEL_GRAY1_PAGE)

#ifdef __cplusplus
}
#endif

#endif
