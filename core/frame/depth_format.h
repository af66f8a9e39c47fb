/* SPDX-License-Identifier: MIT */
/*
 * Operations on depth buffers of other formats than linear16. A surface's depth format names them,
 * so that the linker drops them elsewhere. Internal.
 */
#ifndef QTRI_FRAME_DEPTH_FORMAT_H
#define QTRI_FRAME_DEPTH_FORMAT_H

#include <stdbool.h>
#include <stddef.h>

#include "qtri/error.h"
#include "qtri/surface.h"

struct qtri_depth_ops {
    /* Fills a rectangle, which is not empty and inside of the surface, with a depth. */
    void (*fill)(const qtri_surface *surface, const qtri_rect *rect, uint32_t depth_16p16);
    /*
     * Turns all depths into linear16, in place: the first in memory is returned, and the others
     * follow in the order of the formerly stored ones. |depth_pitch| >= width.
     */
    uint16_t *(*flatten)(const qtri_surface *surface);
};

/* For qtri_depth_format.encode and .decode. */
void qtri_depth_to_float16(uint32_t *depth, int32_t count);
void qtri_depth_from_float16(uint32_t *depth, int32_t count);
void qtri_depth_to_linear24(uint32_t *depth, int32_t count);
void qtri_depth_from_linear24(uint32_t *depth, int32_t count);
void qtri_depth_as_it_is(uint32_t *depth, int32_t count); /* linear32 */

/* NULL: the surface's depths are linear16. */
static inline const qtri_depth_ops *qtri_depth_ops_of(const qtri_surface *surface)
{
    return surface->depth_format != NULL ? surface->depth_format->ops : NULL;
}

/* Records of samples, pixels of more than 4 bytes, hold linear16 alone. NULL: linear16. */
static inline bool qtri_depth_goes_with(const qtri_depth_format *depth, const qtri_format *format)
{
    return depth == NULL || depth->ops == NULL ||
           (depth->bytes >= 2 && depth->bytes <= 4 && format->pixels->bytes <= 4);
}

/* Bytes of a stored depth; NULL: of linear16. */
static inline int32_t qtri_depth_bytes(const qtri_depth_format *format)
{
    return format != NULL ? format->bytes : QTRI_DEPTH_LINEAR16_BYTES;
}

/* Assertions on formats, for checked builds. */
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
