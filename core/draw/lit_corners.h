/* SPDX-License-Identifier: MIT */
/*
 * Triangles in a view's lights. Internal.
 */
#ifndef QTRI_DRAW_LIT_CORNERS_H
#define QTRI_DRAW_LIT_CORNERS_H

#include "../bits/bits.h"
#include "corners.h"

/* Whether a triangle that may cross planes shows its back. */
bool qtri_clipped_is_back(const qtri_clip_vertex v[3]);

/* A third, rounded down; three of them fit. */
static inline int32_t qtri_third(int32_t x)
{
    return (int32_t)(qtri_mul_s32(x, 0x55555554) >> 32);
}

#endif
