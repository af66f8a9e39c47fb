/* SPDX-License-Identifier: MIT */
/*
 * SSD1681: e-paper of 200x200 pixels, black and white, over SPI: modules of 1.54 inch. As SSD1680
 * (ssd1680.h), changes alone included; the memory of qtri_ssd1681_partial is the whole image.
 */
#ifndef QTRI_PORT_SSD1681_H
#define QTRI_PORT_SSD1681_H

#include "panel.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The panel of 200x200, refreshed as a whole, and with partial refresh. */
extern const qtri_panel_description qtri_ssd1681, qtri_ssd1681_partial;

/* Memory for bands and rectangles of any shape: 5000 bytes. Unrotated or turned by 180 degrees, a
   row, 25 bytes, is enough for anything. */
#define QTRI_SSD1681_BYTES     QTRI_PANEL_IMAGE_BYTES(200, 200, QTRI_PANEL_GRAY1)
#define QTRI_SSD1681_ROW_BYTES QTRI_PANEL_ROW_BYTES(200, QTRI_PANEL_GRAY1)

#ifdef __cplusplus
}
#endif

#endif
