/* SPDX-License-Identifier: MIT */
#include "qtri/depth.h"

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

const qtri_depth_format qtri_depth_linear24 = {QTRI_DEPTH_LINEAR24_BYTES,
                                               &qtri_depth_testing_stages, encode, decode};
