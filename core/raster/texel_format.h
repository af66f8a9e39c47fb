/* SPDX-License-Identifier: MIT */
/*
 * What the descriptions of texel formats share. Internal.
 */
#ifndef QTRI_RASTER_TEXEL_FORMAT_H
#define QTRI_RASTER_TEXEL_FORMAT_H

#include <stddef.h>

#include "qtri/texture.h"

#include "../frame/barrier.h"

/* Of texture->width_log2 or height_log2, 0..10. */
static inline uint8_t qtri_side_log2(uint8_t log2)
{
    return log2 > 10 ? 10 : log2;
}

#endif
