/* SPDX-License-Identifier: MIT */
/*
 * UC8151D and its like (IL0373): e-paper of 128x296 pixels, black and white, over SPI: modules
 * of 2.9 inch, Badger 2040. Send a frame, whole or in bands, then qtri_panel_refresh: about 2
 * seconds. Its BUSY pin is low while it is busy: the bus's `busy` is true then.
 */
#ifndef QTRI_PORT_UC8151_H
#define QTRI_PORT_UC8151_H

#include "panel.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The panel of 128x296. */
extern const qtri_panel_description qtri_uc8151;

/* Memory for bands and rectangles of any shape: 4736 bytes. Unrotated or turned by 180 degrees, a
   row, 16 bytes, is enough for anything. */
#define QTRI_UC8151_BYTES     QTRI_PANEL_IMAGE_BYTES(128, 296, QTRI_PANEL_GRAY1)
#define QTRI_UC8151_ROW_BYTES QTRI_PANEL_ROW_BYTES(128, QTRI_PANEL_GRAY1)

#ifdef __cplusplus
}
#endif

#endif
