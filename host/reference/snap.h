/* SPDX-License-Identifier: MIT */
/*
 * Snapping to the sub-pixel grid. Coordinates reach 2^29 at the guard band, so the product of two
 * differences fits 61 bits and edge functions 62.
 */
#ifndef QTRI_HOST_REFERENCE_SNAP_H
#define QTRI_HOST_REFERENCE_SNAP_H

#include <math.h>
#include <stdint.h>

#include "clip.h"

/* A window coordinate in units of 2^-bits pixels, to nearest, half up. Coordinates that rounding
   left outside the guard band (a vertex next to w = 0) are moved onto it. */
static inline int64_t ref_snap(long double window, int bits)
{
    const long double guard = ref_guard_band(bits);
    long double kept = window < -guard ? -guard : window > guard ? guard : window;

    return (int64_t)floorl(ldexpl(kept, bits) + 0.5L);
}

#endif
