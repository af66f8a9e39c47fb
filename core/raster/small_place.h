/* SPDX-License-Identifier: MIT */
/* What follows perspective over a small triangle (qtri/body/small_triangle.h). Internal. */
#ifndef QTRI_RASTER_SMALL_PLACE_H
#define QTRI_RASTER_SMALL_PLACE_H

#include "qtri/body/small_setup.h"

/* f (1 + e), |f| <= 2^16, |e| <= 1/4. */
static inline int32_t qtri_small_scaled(int32_t f, int32_t e_q18)
{
    return f + (((f >> 2) * e_q18 + ((int32_t)1 << 15)) >> 16);
}

#endif
