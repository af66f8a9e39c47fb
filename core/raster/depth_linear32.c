/* SPDX-License-Identifier: MIT */
#include "qtri/depth.h"

#include "../bits/bits.h"
#include "depth_rows.h"

/* Where one is out of range, each is a piece; those between two that are in it are as well. */
static int32_t find_piece(qtri_depth_piece *p, uint32_t z, uint32_t step, int32_t count)
{
    const uint32_t first = z - QTRI_DEPTH_HALF;
    const uint32_t last = first + (uint32_t)(count - 1) * step;
    const bool inside = first <= QTRI_DEPTH_FARTHEST && last <= QTRI_DEPTH_FARTHEST;
    p->z = inside ? first : qtri_depth_of(z);
    p->step = step;
    return inside ? count : 1;
}

#define BYTES    4
#define SHIFT(p) ((void)(p), 0)
#include "depth_rows.inc"

/* Depths are stored as they are: NOLINTNEXTLINE(readability-non-const-parameter) */
static void keep(uint32_t *depth, int32_t count)
{
    (void)depth;
    (void)count;
}

static const qtri_depth_testing testing = QTRI_DEPTH_TESTING(test_row, NULL);
const qtri_depth_format qtri_depth_linear32 = {QTRI_DEPTH_LINEAR32_BYTES, &testing, keep, keep,
                                               QTRI_LINEAR32};
