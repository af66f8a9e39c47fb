/*
 * Snapping to the sub-pixel grid, and the integers that hold products of snapped coordinates.
 */
#ifndef QTRI_HOST_REFERENCE_SNAP_H
#define QTRI_HOST_REFERENCE_SNAP_H

#include <math.h>
#include <stdint.h>

#include "clip.h"

/* Snapped coordinates reach 2^22 * 2^16; the product of two differences needs 79 bits. */
__extension__ typedef __int128 ref_int128;

/* A window coordinate in units of 2^-bits pixels, to nearest, half up. Coordinates that rounding
   left outside the guard band (a vertex next to w = 0) are moved onto it. */
static inline int64_t ref_snap(long double window, int bits)
{
    const long double guard = REF_GUARD_BAND;
    long double kept = window < -guard ? -guard : window > guard ? guard : window;

    return (int64_t)floorl(ldexpl(kept, bits) + 0.5L);
}

#endif
