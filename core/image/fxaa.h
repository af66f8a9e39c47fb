/*
 * What both forms of FXAA share. Internal.
 */
#ifndef QTRI_IMAGE_FXAA_H
#define QTRI_IMAGE_FXAA_H

#include "qtri/image.h"

#include "mix.h"

/* Differences of luma below this stay, as do those below 1/8 of the greatest. */
enum { QTRI_FXAA_LEAST = 10 };

/* 2^16 / n, rounded, for lengths of edges. */
extern const uint16_t qtri_fxaa_inverses[2 * QTRI_FXAA_REACH + 1];

static inline int32_t qtri_fxaa_magnitude(int32_t x)
{
    return x < 0 ? -x : x;
}

#endif
