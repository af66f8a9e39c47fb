/* SPDX-License-Identifier: MIT */
/*
 * Rows of any triangle by stages. Internal.
 */
#ifndef QTRI_RASTER_SPAN_H
#define QTRI_RASTER_SPAN_H

#include "job.h"
#include "linear.h"
#include "perspective.h"
#include "stage_color.h"
#include "texel_number.h"
#include "textured.h"

#endif
