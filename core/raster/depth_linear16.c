/* SPDX-License-Identifier: MIT */
#include "qtri/depth.h"

#include <stddef.h>

/* <= 65535.0: the half does not carry out of 32 bits. */
static void encode(uint32_t *depth, int32_t count)
{
    for (int32_t i = 0; i < count; i++) {
        depth[i] = (depth[i] + 0x8000) >> 16;
    }
}

static void decode(uint32_t *depth, int32_t count)
{
    for (int32_t i = 0; i < count; i++) {
        depth[i] <<= 16;
    }
}

const qtri_depth_format qtri_depth_linear16 = {QTRI_DEPTH_LINEAR16_BYTES, NULL, encode, decode,
                                               QTRI_LINEAR16};
