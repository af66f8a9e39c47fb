/*
 * Indexed triangle meshes: constant data, so that they can stay in flash.
 */
#ifndef QTRI_MESH_H
#define QTRI_MESH_H

#include <stdint.h>

#include "material.h"
#include "vec.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A unit normal in Q2.14. */
typedef struct qtri_normal {
    int16_t x, y, z;
} qtri_normal;

typedef struct qtri_mesh {
    const qtri_vec3 *positions;     /* vertex_count, object space */
    const qtri_normal *normals;     /* vertex_count, or NULL: lit per face */
    const qtri_vec2 *uvs;           /* vertex_count, or NULL: not textured */
    const qtri_rgb *colors;         /* vertex_count, or NULL: the material's colour */
    const uint16_t (*triangles)[3]; /* triangle_count; an index past the end skips its triangle */
    uint32_t vertex_count, triangle_count;
} qtri_mesh;

#ifdef __cplusplus
}
#endif

#endif
