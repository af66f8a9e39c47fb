/* SPDX-License-Identifier: MIT */
/*
 * ST7789: TFT of up to 240x320 pixels, RGB565 over SPI. Its glass is normally black and shows
 * colours as they are with inversion on. Some modules are wired blue first: a qtri_module with
 * swap_red_blue, which those of 135x240 mostly want.
 */
#ifndef QTRI_PORT_ST7789_H
#define QTRI_PORT_ST7789_H

#include "panel.h"

#ifdef __cplusplus
extern "C" {
#endif

extern const qtri_panel_description qtri_st7789;         /* 240x320 */
extern const qtri_panel_description qtri_st7789_240x240; /* rows 0..239 of the memory */
extern const qtri_panel_description qtri_st7789_240x280; /* 1.69 inch, from row 20 */
extern const qtri_panel_description qtri_st7789_135x240; /* 1.14 inch, from column 52, row 40 */
extern const qtri_panel_description qtri_st7789_170x320; /* 1.9 inch, from column 35 */
extern const qtri_panel_description qtri_st7789_172x320; /* 1.47 inch, from column 34 */

#ifdef __cplusplus
}
#endif

#endif
