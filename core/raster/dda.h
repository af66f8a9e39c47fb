/* SPDX-License-Identifier: MIT */
/*
 * Exact digital differential analyser: floor of a rational that advances by a constant. Internal.
 *
 * Edges of triangles and lines both ask, once a row or column, at which pixel a straight line is.
 * The answer is kept as a quotient and a remainder, so that no row adds an error.
 */
#ifndef QTRI_RASTER_DDA_H
#define QTRI_RASTER_DDA_H

#include "qtri/body/dda.h"

/*
 * value(k) = floor((start length + (k 256 + along) delta + bias) / (256 length)), k = 0, 1, ...:
 * all in 1/256 pixel. 0 < length <= 2^23, |delta| <= 2^23, 0 <= along < length,
 * 0 <= bias <= 128 length, |start| <= 2^22.
 */
void qtri_dda_init(qtri_dda *dda, int32_t start, int32_t delta, int32_t length, int32_t along,
                   int32_t bias);

/* x / divisor < 2^32 for x < 2^55 and divisor <= 2^23, in digits of eight bits. */
uint32_t qtri_divide_long(uint64_t x, uint32_t divisor, uint32_t *remainder);

static inline void qtri_dda_next(qtri_dda *dda)
{
    dda->value += dda->step;
    dda->remainder += dda->remainder_step; /* both < denominator <= 2^31: no overflow */
    if (dda->remainder >= dda->denominator) {
        dda->remainder -= dda->denominator;
        dda->value++;
    }
}

#endif
