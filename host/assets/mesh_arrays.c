/* SPDX-License-Identifier: MIT */
#include "mesh_arrays.h"

#include <stdlib.h>
#include <string.h>

#include "../io/xalloc.h"

/* clang-format off */
#define KIND(member, name, type, numbers, bytes, is_signed, of_triangles) \
    {#member, name, type, offsetof(qtri_mesh, member), numbers, bytes, is_signed, of_triangles}

const struct mesh_array_kind mesh_array_kinds[MESH_ARRAYS] = {
    [MESH_POSITIONS]   = KIND(positions,    "positions", "qtri_vec3",       3, 4, true,  false),
    [MESH_POSITIONS16] = KIND(positions16,  "positions", "qtri_position16", 3, 2, true,  false),
    [MESH_NORMALS]     = KIND(normals,      "normals",   "qtri_normal",     3, 2, true,  false),
    [MESH_NORMALS8]    = KIND(normals8,     "normals",   "qtri_normal8",    3, 1, true,  false),
    [MESH_UVS]         = KIND(uvs,          "uvs",       "qtri_vec2",       2, 4, true,  false),
    [MESH_UVS16]       = KIND(uvs16,        "uvs",       "qtri_uv16",       2, 2, true,  false),
    [MESH_COLORS]      = KIND(colors,       "colors",    "qtri_rgb",        3, 1, false, false),
    [MESH_TRIANGLES]   = KIND(triangles,    "triangles", "uint16_t",        3, 2, false, true),
    [MESH_TRIANGLES8]  = KIND(triangles8,   "triangles", "uint8_t",         3, 1, false, true),
    [MESH_PLANES]      = KIND(faces.planes, "planes",    "qtri_face8",      4, 1, true,  true),
    [MESH_NEIGHBOURS]  = KIND(neighbours,   "neighbours", "uint16_t",       3, 2, false, true),
};
/* clang-format on */

/* Pointers to constant data of any type are read and set as what they point to is written here. */
void *mesh_array(const qtri_mesh *mesh, enum mesh_array which)
{
    void *array;
    memcpy(&array, (const char *)mesh + mesh_array_kinds[which].at, sizeof array);
    return array;
}

static void set(qtri_mesh *mesh, enum mesh_array which, const void *array)
{
    memcpy((char *)mesh + mesh_array_kinds[which].at, &array, sizeof array);
}

static size_t element_bytes(enum mesh_array which)
{
    return (size_t)mesh_array_kinds[which].numbers * (size_t)mesh_array_kinds[which].bytes;
}

size_t mesh_array_count(const qtri_mesh *mesh, enum mesh_array which)
{
    return mesh_array_kinds[which].of_triangles ? mesh->triangle_count : mesh->vertex_count;
}

size_t mesh_array_bytes(const qtri_mesh *mesh)
{
    size_t bytes = 0;
    for (enum mesh_array i = 0; i < MESH_ARRAYS; i++) {
        bytes += mesh_array(mesh, i) != NULL ? element_bytes(i) * mesh_array_count(mesh, i) : 0;
    }
    return bytes;
}

void mesh_array_create(qtri_mesh *mesh, enum mesh_array which)
{
    set(mesh, which, xcalloc(mesh_array_count(mesh, which), element_bytes(which)));
}

void mesh_array_free(qtri_mesh *mesh, enum mesh_array which)
{
    free(mesh_array(mesh, which));
    set(mesh, which, NULL);
}

void mesh_array_get(const qtri_mesh *mesh, enum mesh_array which, size_t i, int32_t *numbers)
{
    const struct mesh_array_kind *kind = &mesh_array_kinds[which];
    const void *element = (const char *)mesh_array(mesh, which) + i * element_bytes(which);
    for (int k = 0; k < kind->numbers; k++) {
        numbers[k] = kind->bytes == 4   ? ((const int32_t *)element)[k]
                     : kind->bytes == 2 ? ((const int16_t *)element)[k]
                                        : ((const int8_t *)element)[k];
        if (!kind->is_signed) {
            numbers[k] &= kind->bytes == 2 ? UINT16_MAX : UINT8_MAX;
        }
    }
}

void mesh_array_put(const qtri_mesh *mesh, enum mesh_array which, size_t i, const int32_t *numbers)
{
    const struct mesh_array_kind *kind = &mesh_array_kinds[which];
    void *element = (char *)mesh_array(mesh, which) + i * element_bytes(which);
    for (int k = 0; k < kind->numbers; k++) {
        if (kind->bytes == 4) {
            ((int32_t *)element)[k] = numbers[k];
        } else if (kind->bytes == 2) {
            ((int16_t *)element)[k] = (int16_t)numbers[k];
        } else {
            ((int8_t *)element)[k] = (int8_t)numbers[k];
        }
    }
}

void mesh_array_fill(qtri_mesh *mesh, enum mesh_array which, const int32_t *numbers)
{
    mesh_array_create(mesh, which);
    for (size_t i = 0; i < mesh_array_count(mesh, which); i++) {
        mesh_array_put(mesh, which, i, numbers);
        numbers += mesh_array_kinds[which].numbers;
    }
}

void mesh_arrays_free(qtri_mesh *mesh)
{
    for (enum mesh_array i = 0; i < MESH_ARRAYS; i++) {
        mesh_array_free(mesh, i);
    }
}
