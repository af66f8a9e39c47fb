/* SPDX-License-Identifier: MIT */
/*
 * Encodes, decodes and compares pixels and depths as surfaces store them. Internal, part of the
 * pipelines' body (pipeline_make.h).
 */
#ifndef QTRI_BODY_STORED_H
#define QTRI_BODY_STORED_H

#include "options.h"

/* Formats of surfaces -------------------------------------------------------------------------- */

QTRI_BODY uint32_t qtri_pixel_bytes(const qtri_options *o)
{
#if defined(QTRI_PIPELINE_IS_ANY_BY_ASKS)
    return o->pixel_bytes;
#else
    switch (o->format) {
    case QTRI_RGB565:
    case QTRI_RGB565_SWAPPED:
    case QTRI_RGB565_EXACT:
        return 2;
    case QTRI_RGB888:
    case QTRI_BGR888:
        return 3;
    case QTRI_XRGB8888:
        return 4;
    case QTRI_GRAY8:
        return 1;
    case QTRI_DEPTH_ONLY:
        return 0;
    default:
        return o->pixel_bytes;
    }
#endif
}

/* A colour of the pipeline's kind as it is stored; of a fine one a mixture has made RGB565. */
QTRI_BODY uint32_t qtri_encode(const qtri_options *o, const qtri_surface *surface, uint32_t c)
{
    if (qtri_stores_565(o) && qtri_kind_of(o) == QTRI_IN_888) {
        c = qtri_pixel_888_to_565(c);
    }
    switch (o->format) {
    case QTRI_RGB565_SWAPPED:
        return qtri_swap_16(c);
    case QTRI_RGB565_EXACT:
        return qtri_pixel_888_to_565(c);
    case QTRI_RGB888:
        return qtri_swap_red_blue(c);
    case QTRI_GRAY8:
        return qtri_kind_of(o) == QTRI_IN_GRAY ? c : qtri_pixel_888_to_luma(c);
    case QTRI_OTHER_FORMAT:
        return o->encode != NULL ? o->encode(c & 0xFFFFFFu)
                                 : qtri_encode_other(surface->format, c & 0xFFFFFFu);
    case QTRI_BGR888:
    case QTRI_XRGB8888:
        return qtri_has_alpha(o) ? c & 0xFFFFFFu : c;
    default:
        return c;
    }
}

/* A stored pixel of RGB565 as a colour of the kind. */
QTRI_BODY uint32_t qtri_decode_565(const qtri_options *o, uint32_t stored)
{
    return qtri_kind_of(o) == QTRI_IN_565   ? stored
           : qtri_kind_of(o) == QTRI_IN_888 ? qtri_pixel_565_to_888(stored)
                                            : qtri_pixel_565_to_fine(stored);
}

/* A stored pixel as a colour in qtri_kind_of(o). */
QTRI_BODY uint32_t qtri_decode(const qtri_options *o, const qtri_surface *surface, uint32_t stored)
{
    switch (o->format) {
    case QTRI_RGB565:
        return qtri_decode_565(o, stored);
    case QTRI_RGB565_SWAPPED:
        return qtri_decode_565(o, qtri_swap_16(stored));
    case QTRI_RGB565_EXACT:
        return qtri_pixel_565_to_888(stored);
    case QTRI_RGB888:
        return qtri_swap_red_blue(stored);
    case QTRI_GRAY8:
        return qtri_kind_of(o) == QTRI_IN_GRAY ? stored : stored * 0x010101u;
    case QTRI_OTHER_FORMAT:
        return o->decode != NULL ? o->decode(stored) : surface->format->decode(stored);
    default:
        return stored;
    }
}

/* Depth ---------------------------------------------------------------------------------------- */

QTRI_BODY uint32_t qtri_depth_size(const qtri_options *o, const qtri_surface *surface)
{
#if defined(QTRI_PIPELINE_IS_ANY_BY_ASKS)
    (void)surface;
    return o->depth_bytes;
#else
    return o->depth == QTRI_LINEAR24      ? 3
           : o->depth == QTRI_LINEAR32    ? 4
           : o->depth == QTRI_OTHER_DEPTH ? surface->depth_format->bytes
                                          : 2;
#endif
}

/* Depths of a walk have this half of a unit of linear16 more, so that cutting rounds. In finer
   formats it keeps depths that rounding moves past an end from wrapping. */
#define QTRI_DEPTH_HALF 0x8000u

/* The depth without that half, 0..65535.0. */
QTRI_BODY uint32_t qtri_depth_of(uint32_t z)
{
    const uint32_t farthest = (uint32_t)65535 << 16;
    z = z < QTRI_DEPTH_HALF ? 0 : z - QTRI_DEPTH_HALF;
    return z > farthest ? farthest : z;
}

/* A depth of the walk as it is stored. */
QTRI_BODY uint32_t qtri_depth_encode(const qtri_options *o, const qtri_surface *surface, uint32_t z)
{
    switch (o->depth) {
    case QTRI_LINEAR24:
        return (qtri_depth_of(z) + 0x80) >> 8;
    case QTRI_LINEAR32:
        return qtri_depth_of(z);
    case QTRI_FLOAT16:
        return qtri_depth_encode_float16(qtri_depth_of(z));
    case QTRI_OTHER_DEPTH:
        return qtri_depth_encode_other(surface->depth_format, qtri_depth_of(z));
    default:
        return z >> 16;
    }
}

/* Depths are stored in 24 bits at most. */
QTRI_BODY bool qtri_depth_is_narrow(const qtri_options *o)
{
    return o->depth <= QTRI_LINEAR24;
}

/* Sets the comparison by bits: whether depths less than (1), equal to (2) and greater than (4) the
   stored one pass. A narrow one passes where its difference to that is one of pass_count from
   -pass_first on. */
QTRI_BODY void qtri_walk_set_compare(const qtri_options *o, qtri_pixel_walk *w, uint32_t passes)
{
    const uint32_t most = (uint32_t)1 << 24;
    const uint32_t less = passes & 1, equal = passes >> 1 & 1, greater = passes >> 2;
    const bool not_equal = less != 0 && equal == 0 && greater != 0; /* all from 1 to -1 */
    w->passes = (uint8_t)passes;
    if (qtri_depth_is_narrow(o)) {
        w->pass_first = less != 0 && !not_equal ? most : equal - 1;
        w->pass_count = not_equal ? UINT32_MAX : (less + greater) * most + equal;
    }
}

/* Whether a depth, as it is stored, passes the test against a stored one. */
QTRI_BODY bool qtri_depth_passes(const qtri_options *o, const qtri_pixel_walk *w, uint32_t z,
                                 uint32_t stored)
{
    if (qtri_compares_by_any(o)) {
        return qtri_depth_is_narrow(o) ? z - stored + w->pass_first < w->pass_count
                                       : (w->passes >> ((z >= stored) + (z > stored)) & 1) != 0;
    }
    switch (o->compare) {
    case QTRI_LESS:
        return z < stored;
    case QTRI_LESS_EQUAL:
        return z <= stored;
    case QTRI_GREATER:
        return z > stored;
    case QTRI_GREATER_EQUAL:
        return z >= stored;
    case QTRI_EQUAL:
        return z == stored;
    case QTRI_NOT_EQUAL:
        return z != stored;
    default:
        return true;
    }
}

/* Whether a pixel that passes writes its depth. */
QTRI_BODY bool qtri_pixel_writes(const qtri_options *o, const qtri_pixel_walk *w)
{
    return qtri_writes_depth(o) && (o->read_only != QTRI_ANY || !w->keeps_depth);
}

/* Bytes from a pixel to the next: a pixel of four samples is a record (antialias.h). */
QTRI_BODY uint32_t qtri_pixel_step(const qtri_options *o)
{
    const uint32_t bytes = qtri_pixel_bytes(o);
    return !qtri_has_samples(o) ? bytes : bytes == 4 ? 24 : 4 * bytes + 6;
}

/* A pixel has as many bytes as its depth: one pointer serves both, see qtri_small_pixels(). */
QTRI_BODY bool qtri_is_paired(const qtri_options *o)
{
#ifdef QTRI_PIPELINE_IS_ANY
    (void)o;
    return false;
#else
    return qtri_tests_depth(o) && /* of one sample: others have loops of their own */
           ((o->depth <= QTRI_FLOAT16 && qtri_pixel_bytes(o) == 2) ||
            (o->depth == QTRI_LINEAR32 && qtri_pixel_bytes(o) == 4));
#endif
}

#endif
