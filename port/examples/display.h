/* SPDX-License-Identifier: MIT */
/*
 * The display that the examples have on this computer: in memory (lcd, 320x240), or a simulated
 * controller of host/panels: an OLED's, the SSD0323 (oled, 128x64), or e-paper's, the SSD1680
 * (paper, 250x122). display.c has example_display of example.h.
 */
#ifndef QTRI_EXAMPLES_DISPLAY_H
#define QTRI_EXAMPLES_DISPLAY_H

#include <stdbool.h>

/* lcd, oled or paper; false: another name. lcd at first. */
bool display_choose(const char *name);

/* What is seen at a pixel of the frame. */
void display_pixel(int x, int y, unsigned char rgb[3]);

/* The simulated controller's first complaint, NULL: it has none. */
const char *display_complaint(void);

#endif
