/* SPDX-License-Identifier: MIT */
/*
 * Surfaces with several samples a pixel, as their formats describe them. Internal; samples.h has
 * their memory.
 */
#ifndef QTRI_RASTER_SAMPLING_H
#define QTRI_RASTER_SAMPLING_H

#include <stddef.h>

#include "qtri/pipeline.h"

struct qtri_sampling {
    const qtri_format *format; /* of resolved pixels */
    /* Where a view's list has nothing but the generic pipeline that fits; the last one fits. */
    const qtri_pipeline *const *pipelines;
};

/* NULL: one a pixel. */
static inline const qtri_sampling *qtri_sampling_of(const qtri_format *format)
{
    return format != NULL ? format->samples : NULL;
}

#endif
