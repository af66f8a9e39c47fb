/* SPDX-License-Identifier: MIT */
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

/* A compact normal. */
typedef struct qtri_normal8 {
    int8_t x, y, z;
} qtri_normal8;

/* Compact texture coordinates. */
typedef struct qtri_uv16 {
    int16_t x, y;
} qtri_uv16;

/*
 * Planes of a mesh's faces: those that turn away are left out before their vertices are
 * transformed. A draw call that culls back or front faces then transforms and lights a vertex when
 * the first face that may be seen needs it, mostly half of them; where no triangle is culled, or
 * the mesh reaches the eye, the near or the far plane, they are not used. The pixels stay the same,
 * but for the light, see below. They pay for closed meshes of more than a few hundred triangles.
 *
 * For a triangle with corners a b c, real numbers, as they are stored:
 *
 *   x y z   round(s n) for n = (b - a) x (c - a) of length 1, and a length s of the face's own that
 *           leaves x y z at least 16 long. Or 0 0 0, no plane, where that cannot be: of a face that
 *           is too thin, too small or without area; it is looked at as in a mesh without planes
 *   d       round((x y z) . (a - origin) / extent), for s so small that it fits
 *
 * s is best as large as the other faces' `thin` allows: it makes thin faces' normals short. In
 * place of round(s n) any near whole numbers will do, and some lengths s are nearer to such than
 * others. What makes them, and leaves them out where they do not pay, is host/tools/mesh_faces.h.
 *
 * A face that is lit as a whole has the light of x y z: off from that of n by its angle to n times
 * the light's diffuse part; the angle is up to 1/64, half a step of RGB565, as mesh_faces.h makes
 * them. Light on a mesh that camera and pose scale unevenly or shear keeps that of n, and so does
 * that of 0 0 0.
 */
typedef struct qtri_face8 {
    int8_t x, y, z, d;
} qtri_face8;

/* What leaves faces out by their planes: linked where a mesh names it. */
typedef struct qtri_face_culling qtri_face_culling;
extern const qtri_face_culling qtri_cull_by_planes;

/* The planes of a mesh, and how far they may be off. */
typedef struct qtri_faces {
    const qtri_face_culling *culling; /* &qtri_cull_by_planes; NULL: for light only */
    const qtri_face8 *planes;         /* triangle_count, or NULL */
    /* Of all faces, each rounded up: */
    uint32_t thin;       /* (x y z) . n extent / r, for the radius r of a face's inner circle,
                            2 area / perimeter */
    uint16_t error_q16;  /* x y z's distance from the line along n */
    uint16_t radius_q14; /* |p - origin| / extent of the positions, at least 1 */
} qtri_faces;

/* The points within `half` of `center`, axis by axis. */
typedef struct qtri_box {
    qtri_vec3 center, half;
} qtri_box;

/* Vertices and triangles: constant data. Wide arrays, or compact ones in their place. */
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
    qtri_vec3 origin; /* of positions16 and faces */
    q16 extent;       /* a wide mesh with faces has the two as well: all positions within it */
    qtri_faces faces;
    qtri_box bounds; /* of all positions, in object space: a mesh that cannot be seen is skipped at
                        once; half = 0: unknown */
    /* triangle_count, or NULL: the triangles across the edges from corner 0 to 1, 1 to 2 and 2 to
       0, or triangle_count where there is none; for outlines, see antialias.h */
    const uint16_t (*neighbours)[3];
} qtri_mesh;

/* A mesh and how it looks: what `qtri model` makes of a file is an array of parts. */
typedef struct qtri_part {
    const qtri_mesh *mesh;
    qtri_material material;
    int16_t node; /* the pose that moves it, where parts move by themselves; else 0 */
} qtri_part;

/* ---- Bounds ---- */

/* The points within `radius` of `center`. */
typedef struct qtri_ball {
    qtri_vec3 center;
    q16 radius;
} qtri_ball;

/*
 * Holds all positions, wide or 16-bit, in object space; no larger than it must be by more than one
 * step on each side, two with 16-bit positions. All 0 without positions. Sides saturate.
 */
qtri_box qtri_mesh_box(const qtri_mesh *mesh);

/* Around the centre of the box: the largest distance of a position, rounded up; saturates. */
qtri_ball qtri_mesh_ball(const qtri_mesh *mesh);

#ifdef __cplusplus
}
#endif

#endif
