/* SPDX-License-Identifier: MIT */
#include "asset.h"

#include <qtri_port/panel.h>
#include <string.h>

#include "mesh_arrays.h"

/* sizeof (qtri_mesh) with 32-bit pointers: 10 of them, 2 counts, origin and extent, faces with 2
   pointers and 8 bytes, bounds. */
#define MESH_BYTES (10 * 4 + 2 * 4 + 16 + 16 + 24)

/* qtri_material there: 9 pointers, 4 enums, depth_bias and depth_slope, color, bool and 3 bytes; a
   part's node with what aligns it. */
#define MATERIAL_BYTES (9 * 4 + 4 * 4 + 2 * 4 + 4 + 4 + 4)
#define NODE_BYTES     4

uint32_t asset_vertex_count(const struct asset *asset)
{
    uint32_t count = 0;
    for (size_t i = 0; i < asset->count; i++) {
        count += asset->parts[i].mesh.vertex_count;
    }
    return count;
}

uint32_t asset_triangle_count(const struct asset *asset)
{
    uint32_t count = 0;
    for (size_t i = 0; i < asset->count; i++) {
        count += asset->parts[i].mesh.triangle_count;
    }
    return count;
}

size_t asset_flash_bytes(const struct asset *asset)
{
    size_t bytes = 0;
    for (size_t i = 0; i < asset->count; i++) {
        const qtri_mesh *mesh = &asset->parts[i].mesh;
        const size_t targets = mesh->vertex_count * sizeof(qtri_position16) + 4; /* a pointer */
        bytes += MESH_BYTES + mesh_array_bytes(mesh) + asset->parts[i].target_count * targets;
    }
    if (asset->radius > 0) { /* a model's parts, and what they name */
        bytes += asset->count * (MATERIAL_BYTES + NODE_BYTES);
        for (size_t i = 0; i < asset->texture_count; i++) {
            bytes += texture_flash_bytes(&asset->textures[i]);
        }
    }
    if (asset->node_count > 0) {
        const size_t tracks = asset->track_count;
        bytes += asset->first_keys[asset->node_count + tracks] * sizeof(qtri_key) + 4 +
                 asset->node_count * (sizeof(int32_t) + sizeof(int16_t)) +
                 tracks * sizeof(int32_t) + (tracks > 0 ? 8 * asset->count + 8 : 0);
    }
    return bytes;
}

/* A prepared mesh each. */
struct asset_memory asset_ram(const struct asset *asset, int32_t width, int32_t height,
                              int32_t rows)
{
    struct asset_memory memory = {
        .bands = QTRI_FRAME_BYTES(width, rows, QTRI_RGB565_BYTES),
        .line = QTRI_PANEL_LINE_BYTES(width),
    };
    if (asset->radius > 0) { /* a screen has two buffers, of which pixels are not shared */
        memory.bands = QTRI_FRAME_BYTES_DOUBLE(width, rows, QTRI_RGB565_BYTES);
    }
    for (size_t i = 0; i < asset->count; i++) {
        const qtri_mesh *mesh = &asset->parts[i].mesh;
        memory.vertices += mesh->vertex_count * sizeof(qtri_vertex);
        if (asset->parts[i].target_count > 0) {
            memory.vertices += mesh->vertex_count * sizeof(qtri_position16) + MESH_BYTES;
        }
        memory.lists += QTRI_PREPARED_LISTS(mesh->triangle_count, height, rows) * sizeof(uint16_t);
    }
    return memory;
}
