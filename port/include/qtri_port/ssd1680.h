/* SPDX-License-Identifier: MIT */
/*
 * SSD1680: e-paper of up to 176x296 pixels, black and white, over SPI; here the 2.13 inch glass of
 * 122x250. Send a frame, whole or in bands, then qtri_panel_refresh: about 2 seconds, BUSY is high.
 * Refresh a few times a minute at most, or the glass suffers.
 *
 * qtri_ssd1680_partial can also qtri_panel_refresh_changes: about 0.4 seconds, without flashing.
 * After each refresh it sends the image once more, to the memory that the controller compares with,
 * and its memory must be the whole image, QTRI_SSD1680_BYTES.
 *
 * A glass of another size is a copy of a description with its width, height and first_column, and
 * with an `init` whose command 0x01 has its last row in place of 249. Its memory is
 * QTRI_PANEL_IMAGE_BYTES(width, height, QTRI_PANEL_GRAY1).
 */
#ifndef QTRI_PORT_SSD1680_H
#define QTRI_PORT_SSD1680_H

#include "panel.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The panel of 122x250, refreshed as a whole, and with partial refresh. */
extern const qtri_panel_description qtri_ssd1680, qtri_ssd1680_partial;

/* Memory for bands and rectangles of any shape: 4000 bytes. Unrotated or turned by 180 degrees, a
   row, 16 bytes, is enough for anything. */
#define QTRI_SSD1680_BYTES     QTRI_PANEL_IMAGE_BYTES(122, 250, QTRI_PANEL_GRAY1)
#define QTRI_SSD1680_ROW_BYTES QTRI_PANEL_ROW_BYTES(122, QTRI_PANEL_GRAY1)

#ifdef __cplusplus
}
#endif

#endif
