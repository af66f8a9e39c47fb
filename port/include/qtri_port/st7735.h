/* SPDX-License-Identifier: MIT */
/*
 * ST7735R and S: TFT of up to 132x162 pixels, RGB565 over SPI. Modules of 1.8 inch differ by the
 * colour of the protecting foil's tab: red and black ones use the memory from its first pixel on,
 * green ones from column 2, row 1; black ones are wired red first, a qtri_module with
 * swap_red_blue.
 */
#ifndef QTRI_PORT_ST7735_H
#define QTRI_PORT_ST7735_H

#include "panel.h"

#ifdef __cplusplus
extern "C" {
#endif

extern const qtri_panel_description qtri_st7735;         /* 128x160: red tab, black tab */
extern const qtri_panel_description qtri_st7735_green;   /* 128x160: green tab */
extern const qtri_panel_description qtri_st7735_128x128; /* 1.44 inch, from column 2, row 1 */

/* IPS glass of 0.96 inch, inverted, from column 26, row 1. A picture that is shifted, and negative,
   wants the next one. */
extern const qtri_panel_description qtri_st7735_80x160;

/* Glass of 0.96 inch with a red tab, not inverted, from column 24. */
extern const qtri_panel_description qtri_st7735_80x160_red;

#ifdef __cplusplus
}
#endif

#endif
