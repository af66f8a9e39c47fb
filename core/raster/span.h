/*
 * Rows of any triangle by stages. Internal.
 */
#ifndef QTRI_RASTER_SPAN_H
#define QTRI_RASTER_SPAN_H

#include "job.h"
#include "perspective.h"
#include "stage_color.h"
#include "texel_number.h"
#include "textured.h"

/* Attributes that are linear on the screen. */
int32_t qtri_interpolate_linear(qtri_scanline *row, int32_t x, int32_t count, int first, int end,
                                qtri_curve *out);

#endif
