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

/*
 * Compact elements, for less flash and, on cores without a long multiply, less than half the work
 * per vertex. Each array takes the place of the wide one when it is not NULL. From real numbers:
 *
 *   positions16   round((p - origin) 32768 / extent), held to +-32767, for each coordinate; the
 *                 same extent for all three, the largest |p - origin| (in Q16.16, rounded up)
 *   normals8      round(127 n) of a unit normal: light within 1/128 of that of the exact normal
 *   uvs16         round(16384 u), round(16384 v): Q2.14, -2 <= u, v < 2
 *   triangles8    for meshes of up to 256 vertices
 */
typedef struct qtri_position16 {
    int16_t x, y, z;
} qtri_position16;

typedef struct qtri_normal8 {
    int8_t x, y, z;
} qtri_normal8;

typedef struct qtri_uv16 {
    int16_t x, y;
} qtri_uv16;

/* The points within `half` of `center`, axis by axis. */
typedef struct qtri_box {
    qtri_vec3 center, half;
} qtri_box;

typedef struct qtri_mesh {
    const qtri_vec3 *positions;     /* vertex_count, object space */
    const qtri_normal *normals;     /* vertex_count, or NULL: lit per face */
    const qtri_vec2 *uvs;           /* vertex_count, or NULL: not textured */
    const qtri_rgb *colors;         /* vertex_count, or NULL: the material's colour */
    const uint16_t (*triangles)[3]; /* triangle_count; an index past the end skips its triangle */
    uint32_t vertex_count, triangle_count;

    /* All that follows may be left zero. */
    const qtri_position16 *positions16; /* object space: origin + extent p / 32768 */
    const qtri_normal8 *normals8;
    const qtri_uv16 *uvs16;
    const uint8_t (*triangles8)[3];
    qtri_vec3 origin; /* of positions16 */
    q16 extent;
    qtri_box bounds; /* of all positions, in object space: a mesh that cannot be seen is skipped at
                        once; half = 0: unknown */
} qtri_mesh;

#ifdef __cplusplus
}
#endif

#endif
