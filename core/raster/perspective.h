/*
 * Attributes with perspective along rows. Internal.
 */
#ifndef QTRI_RASTER_PERSPECTIVE_H
#define QTRI_RASTER_PERSPECTIVE_H

#include "job.h"

/* Before the first row that is filled; then for every row with pixels to draw. */
void qtri_perspective_begin(qtri_scanline *row);
void qtri_perspective_row(qtri_scanline *row);

int32_t qtri_interpolate_perspective(qtri_scanline *row, int32_t x, int32_t count, int first, int end,
                                     qtri_curve *out);

#endif
