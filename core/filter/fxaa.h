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
    const int32_t low_1 = a < b ? a : b;
    const int32_t high_1 = a < b ? b : a;
    const int32_t low_2 = c < d ? c : d;
    const int32_t high_2 = c < d ? d : c;
    int32_t high = high_1 > high_2 ? high_1 : high_2;
    int32_t low = low_1 < low_2 ? low_1 : low_2;
    high = m > high ? m : high;
    low = m < low ? m : low;
    return high - low < QTRI_FXAA_LEAST || (high - low) * 8 < high;
}

#endif
