/* SPDX-License-Identifier: MIT */
/*
 * PCD8544: LCD of 84x48 pixels, one bit each, over SPI of 4 MHz at most: the display of Nokia's
 * 5110. A picture that is too pale or too dark wants another contrast, n in 0..127 about 56:
 *
 *     const qtri_panel_step steps[] = {QTRI_STEP_ALONE(0x21, 0), QTRI_STEP_ALONE(0x80 | n, 0),
 *                                      QTRI_STEP_ALONE(0x20, 0)};
 *     qtri_panel_send(&panel, steps, 3);
 *
 * White is glass as it is, black is dark.
 */
#ifndef QTRI_PORT_PCD8544_H
#define QTRI_PORT_PCD8544_H

#include "panel.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The panel of 84x48. */
extern const qtri_panel_description qtri_pcd8544;

/* Memory for bands and rectangles of any shape: 504 bytes. */
#define QTRI_PCD8544_BYTES QTRI_PANEL_IMAGE_BYTES(84, 48, QTRI_PANEL_GRAY1_PAGE)

#ifdef __cplusplus
}
#endif

#endif
