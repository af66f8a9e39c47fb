/* SPDX-License-Identifier: MIT */
/*
 * A line, stepped by one row or column with an exact fraction: see core/raster/dda.h. Internal,
 * part of the pipelines' body (pipeline_make.h).
 */
#ifndef QTRI_BODY_DDA_H
#define QTRI_BODY_DDA_H

#include <stdint.h>

typedef struct qtri_dda {
    int32_t value; /* the pixel; the fraction is remainder / denominator */
    int32_t step;
    uint32_t remainder, remainder_step; /* below `denominator` */
    uint32_t denominator;               /* 256 length <= 2^31 */
} qtri_dda;

#endif
