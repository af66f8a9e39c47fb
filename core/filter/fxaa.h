/* SPDX-License-Identifier: MIT */
/*
 * What both forms of FXAA share. Internal.
 */
#ifndef QTRI_IMAGE_FXAA_H
#define QTRI_IMAGE_FXAA_H

#include "qtri/filters.h"

#include "mix.h"

/* Differences of luma below this stay, as do those below 1/8 of the greatest. */
enum { QTRI_FXAA_LEAST = 10 };

/* 2^16 / n, rounded, for lengths of edges. */
extern const uint16_t qtri_fxaa_inverses[2 * QTRI_FXAA_REACH + 1];

static inline int32_t qtri_fxaa_magnitude(int32_t x)
{
    return x < 0 ? -x : x;
}

/* Whether a pixel's luma and that of its four neighbours differ too little to look further. */
static inline bool qtri_fxaa_is_flat(int32_t m, int32_t a, int32_t b, int32_t c, int32_t d)
{
    int32_t high = m;
    int32_t low = m;
    high = a > high ? a : high;
    low = a < low ? a : low;
    high = b > high ? b : high;
    low = b < low ? b : low;
    high = c > high ? c : high;
    low = c < low ? c : low;
    high = d > high ? d : high;
    low = d < low ? d : low;
    return high - low < QTRI_FXAA_LEAST || (high - low) * 8 < high;
}

#endif
