/* SPDX-License-Identifier: MIT */
#include "asset.h"

#include <stdlib.h>
#include <string.h>

#ifdef QTRI_HAVE_MESHOPTIMIZER

#include <meshoptimizer.h>

bool asset_order_triangles(uint32_t (*triangles)[3], size_t count, size_t vertices)
{
    unsigned int *indices = calloc(3 * count + 3, sizeof *indices);
    if (indices == NULL) {
        return false;
    }
    for (size_t i = 0; i < 3 * count; i++) {
        indices[i] = triangles[i / 3][i % 3];
    }
    meshopt_optimizeVertexCache(indices, indices, 3 * count, vertices);
    for (size_t i = 0; i < 3 * count; i++) {
        triangles[i / 3][i % 3] = indices[i];
    }
    free(indices);
    return true;
}

#else

bool asset_order_triangles(uint32_t (*triangles)[3], size_t count, size_t vertices)
{
    (void)triangles;
    (void)count;
    (void)vertices;
    return true;
}

#endif
