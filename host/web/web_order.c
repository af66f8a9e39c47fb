/* SPDX-License-Identifier: MIT */
/* The library meshoptimizer is a module of its own, which engine.js has where it is there. */
#include "../assets/asset.h"

void page_order(uint32_t *indices, size_t count); /* engine.js */

void asset_order_triangles(uint32_t (*triangles)[3], size_t count, size_t vertices)
{
    (void)vertices;
    page_order(triangles[0], 3 * count);
}
