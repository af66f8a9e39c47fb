/* SPDX-License-Identifier: MIT */
/*
 * ST7796S: TFT of 320x480 pixels, RGB565 over SPI: modules of 3.5 and 4 inch, often sold beside
 * those with an ILI9488, which look alike. IPS modules want a qtri_module with invert.
 */
#ifndef QTRI_PORT_ST7796_H
#define QTRI_PORT_ST7796_H

#include "panel.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The panel of 320x480. */
extern const qtri_panel_description qtri_st7796;

#ifdef __cplusplus
}
#endif

#endif
