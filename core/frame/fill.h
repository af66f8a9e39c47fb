/* SPDX-License-Identifier: MIT */
/*
 * Memory filled with one value, in the widest stores that there are. Internal.
 */
#ifndef QTRI_FRAME_FILL_H
#define QTRI_FRAME_FILL_H

#include "qtri/surface.h"

/*
 * Fills `rows` rows of `bytes` > 0 bytes with a word `value` as it lies in memory, at whichever
 * byte a row begins. Rows without gaps are one row.
 */
void qtri_fill_words(uint8_t *first, ptrdiff_t pitch, size_t bytes, int32_t rows, uint32_t value);

/* Fills a rectangle, which is not empty and lies in qtri_surface_bounds, with a stored pixel. */
void qtri_fill_rect(const qtri_surface *surface, const qtri_rect *rect, uint32_t stored);

#endif
