/* SPDX-License-Identifier: MIT */
/*
 * ILI9488: TFT of 320x480 pixels, over SPI with three bytes a pixel, of six bits each: half as long
 * a transfer again as RGB565's. Surfaces of any format are converted. IPS modules want a
 * qtri_module with invert.
 */
#ifndef QTRI_PORT_ILI9488_H
#define QTRI_PORT_ILI9488_H

#include "panel.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The panel of 320x480. */
extern const qtri_panel_description qtri_ili9488;

#ifdef __cplusplus
}
#endif

#endif
