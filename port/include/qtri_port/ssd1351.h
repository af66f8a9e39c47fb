/* SPDX-License-Identifier: MIT */
/*
 * SSD1351: colour OLED of 128x128 pixels, RGB565 over SPI: modules of 1.5 inch.
 */
#ifndef QTRI_PORT_SSD1351_H
#define QTRI_PORT_SSD1351_H

#include "panel.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The panel of 128x128. */
extern const qtri_panel_description qtri_ssd1351;

#ifdef __cplusplus
}
#endif

#endif
