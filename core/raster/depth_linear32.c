/* SPDX-License-Identifier: MIT */
#include "qtri/depth.h"

/* Depths are stored as they are: NOLINTNEXTLINE(readability-non-const-parameter) */
static void keep(uint32_t *depth, int32_t count)
{
    (void)depth;
    (void)count;
}

const qtri_depth_format qtri_depth_linear32 = {QTRI_DEPTH_LINEAR32_BYTES,
                                               &qtri_depth_testing_stages, keep, keep};
