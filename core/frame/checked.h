/* SPDX-License-Identifier: MIT */
/*
 * Checks of descriptions of pixels and depths, for checked builds. Internal.
 */
#ifndef QTRI_FRAME_CHECKED_H
#define QTRI_FRAME_CHECKED_H

#include "../bits/bits.h"
#include "depth_format.h"

#ifdef QTRI_CHECKED
static inline void qtri_check_format(const qtri_format *format)
{
    QTRI_ASSERT(format == NULL || (format->pixels != NULL && format->colors != NULL));
}

static inline void qtri_check_depth_format(const qtri_depth_format *format)
{
    QTRI_ASSERT(format == NULL || format->ops == NULL ||
                (format->encode != NULL && format->decode != NULL));
}
#endif

#endif
