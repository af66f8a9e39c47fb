/* SPDX-License-Identifier: MIT */
/* What the controllers of black and white OLEDs have in common: commands that drive the glass. */
#ifndef QTRI_HOST_PANELS_OLED_H
#define QTRI_HOST_PANELS_OLED_H

#include "chip.h"

typedef struct oled_drive {
    int multiplex, offset, start_line, pins;
    bool columns_reversed, rows_reversed, inverse, all_on, on, pump;
} oled_drive;

/* Values of reset. Modules whose supply is slow are not ready for 100 ms. */
void oled_reset(chip *it, oled_drive *drive);

/* Carries out a command; false: it is none of these. */
bool oled_execute(chip *it, oled_drive *drive);

/* What row y of the glass shows, of so many, the last COM on top. segment: the first page of its
   column of the memory, whose pages are `pitch` bytes. */
uint32_t oled_pixel(const oled_drive *drive, int rows, int y, const uint8_t *segment, int pitch);

#endif
