/* SPDX-License-Identifier: MIT */
#include "asset.h"

#include <stdlib.h>
#include <string.h>

#ifdef QTRI_HAVE_MESHOPTIMIZER

#include <meshoptimizer.h>

#include "../io/xalloc.h"

void asset_order_triangles(uint32_t (*triangles)[3], size_t count, size_t vertices)
{
    unsigned int *indices = xcalloc(3 * count, sizeof *indices);
    for (size_t i = 0; i < 3 * count; i++) {
        indices[i] = triangles[i / 3][i % 3];
    }
    meshopt_optimizeVertexCache(indices, indices, 3 * count, vertices);
    for (size_t i = 0; i < 3 * count; i++) {
        triangles[i / 3][i % 3] = indices[i];
    }
    free(indices);
}

#else

void asset_order_triangles(uint32_t (*triangles)[3], size_t count, size_t vertices)
{
    (void)triangles;
    (void)count;
    (void)vertices;
}

#endif
