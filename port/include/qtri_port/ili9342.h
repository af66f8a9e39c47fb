/* SPDX-License-Identifier: MIT */
/*
 * ILI9342C: TFT of 320x240 pixels, landscape by nature, RGB565 over SPI: M5Stack's Core and its
 * like. Its glass is normally black, wired blue first; early ones (before 2019) are not inverted: a
 * qtri_module with invert.
 */
#ifndef QTRI_PORT_ILI9342_H
#define QTRI_PORT_ILI9342_H

#include "panel.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The panel of 320x240. */
extern const qtri_panel_description qtri_ili9342;

#ifdef __cplusplus
}
#endif

#endif
