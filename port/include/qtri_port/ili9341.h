/* SPDX-License-Identifier: MIT */
/*
 * ILI9341: TFT of 240x320 pixels, RGB565 over SPI. Modules are wired so that columns run from the
 * right and colours blue first; the descriptions allow for both.
 */
#ifndef QTRI_PORT_ILI9341_H
#define QTRI_PORT_ILI9341_H

#include "panel.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The panel of 240x320. */
extern const qtri_panel_description qtri_ili9341;

#ifdef __cplusplus
}
#endif

#endif
