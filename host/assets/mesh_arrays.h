/* SPDX-License-Identifier: MIT */
/*
 * The arrays of a qtri_mesh as one table, by which they are made, counted, written and freed.
 */
#ifndef QTRI_HOST_ASSETS_MESH_ARRAYS_H
#define QTRI_HOST_ASSETS_MESH_ARRAYS_H

#include <qtri.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* In the order in which they are written. */
enum mesh_array {
    MESH_POSITIONS,
    MESH_POSITIONS16,
    MESH_NORMALS,
    MESH_NORMALS8,
    MESH_UVS,
    MESH_UVS16,
    MESH_COLORS,
    MESH_TRIANGLES,
    MESH_TRIANGLES8,
    MESH_PLANES,
    MESH_NEIGHBOURS,
    MESH_ARRAYS
};

enum { MESH_NUMBERS = 4 }; /* an element has at most */

struct mesh_array_kind {
    const char *field, *name; /* the member of qtri_mesh; what both sizes of it are called */
    const char *type;         /* in C, of an element or, where that is an array, of its numbers */
    size_t at;                /* where in a qtri_mesh its pointer is */
    int numbers, bytes;       /* of an element; of a number: 1, 2 or 4 */
    bool is_signed, of_triangles;
};
extern const struct mesh_array_kind mesh_array_kinds[MESH_ARRAYS];

/* The mesh's array, or NULL; how many elements it has if it is there, and their bytes. */
void *mesh_array(const qtri_mesh *mesh, enum mesh_array which);
size_t mesh_array_count(const qtri_mesh *mesh, enum mesh_array which);
size_t mesh_array_bytes(const qtri_mesh *mesh);

/* Gives the mesh an array of zeros, the counts being set. */
void mesh_array_create(qtri_mesh *mesh, enum mesh_array which);
void mesh_array_free(qtri_mesh *mesh, enum mesh_array which);
void mesh_arrays_free(qtri_mesh *mesh);

/* Gives the mesh an array of these numbers, one element behind the other. */
void mesh_array_fill(qtri_mesh *mesh, enum mesh_array which, const int32_t *numbers);

/* The numbers of element `i`. */
void mesh_array_get(const qtri_mesh *mesh, enum mesh_array which, size_t i, int32_t *numbers);
void mesh_array_put(const qtri_mesh *mesh, enum mesh_array which, size_t i, const int32_t *numbers);

#endif
