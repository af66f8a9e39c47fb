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
    p->z = (inside ? first : qtri_depth_of(z)) + 0x80; /* the half that rounds */
    p->step = step;
    return inside ? count : 1;
}

#define BYTES    3
#define SHIFT(p) ((void)(p), 8)
#include "depth_rows.inc"

/* <= 65535.0: the half does not carry out of 32 bits. */
static void encode(uint32_t *depth, int32_t count)
{
    for (int32_t i = 0; i < count; i++) {
        depth[i] = (depth[i] + 0x80) >> 8;
    }
}

static void decode(uint32_t *depth, int32_t count)
{
    for (int32_t i = 0; i < count; i++) {
        depth[i] <<= 8;
    }
}

static const qtri_depth_testing testing = QTRI_DEPTH_TESTING(test_row, NULL);
const qtri_depth_format qtri_depth_linear24 = {QTRI_DEPTH_LINEAR24_BYTES, &testing, encode, decode,
                                               QTRI_LINEAR24};
