/* SPDX-License-Identifier: MIT */
/*
 * Meshes that are computed: box, sphere, cylinder, cone, torus, grid, into memory of the caller's.
 *
 *     static qtri_vec3 positions[QTRI_SPHERE_VERTICES(24, 12)];
 *     static qtri_normal normals[QTRI_SPHERE_VERTICES(24, 12)];
 *     static uint16_t triangles[QTRI_SPHERE_TRIANGLES(24, 12)][3];
 *     const qtri_shape_memory memory = {
 *         positions, normals, NULL, triangles,
 *         QTRI_SPHERE_VERTICES(24, 12), QTRI_SPHERE_TRIANGLES(24, 12)};
 *     qtri_mesh mesh;
 *     qtri_shape_sphere(&mesh, &memory, Q16(1), 24, 12);
 *
 * Around the origin, +y up, counter-clockwise seen from outside, with mesh->bounds. u goes once
 * around, v from the top (0) down. Positions are off by 1 ULP and 2^-16 of the size at most,
 * normals by 2^-14; they saturate. A negative size turns the shape inside out.
 *
 * QTRI_ERROR_SIZE: a count outside its range, or more than 65536 vertices. QTRI_ERROR_MEMORY: there
 * is room for too few. *mesh is then empty.
 */
#ifndef QTRI_SHAPES_H
#define QTRI_SHAPES_H

#include "error.h"
#include "mesh.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Arrays of the caller that a shape is written to. */
typedef struct qtri_shape_memory {
    qtri_vec3 *positions;
    qtri_normal *normals; /* NULL: none are wanted */
    qtri_vec2 *uvs;       /* NULL: none are wanted */
    uint16_t (*triangles)[3];
    uint32_t vertices, triangle_count; /* that there is room for */
} qtri_shape_memory;

/* slices around, 3..1024; the other count 1..1024. */
#define QTRI_BOX_VERTICES                   24
#define QTRI_BOX_TRIANGLES                  12
#define QTRI_SPHERE_VERTICES(slices, rows)  (((slices) + 1) * ((rows) + 1))
#define QTRI_SPHERE_TRIANGLES(slices, rows) (2 * (slices) * ((rows)-1))
#define QTRI_CYLINDER_VERTICES(slices)      (6 * ((slices) + 1))
#define QTRI_CYLINDER_TRIANGLES(slices)     (4 * (slices))
#define QTRI_CONE_VERTICES(slices)          (4 * ((slices) + 1))
#define QTRI_CONE_TRIANGLES(slices)         (2 * (slices))
#define QTRI_TORUS_VERTICES(slices, rings)  (((slices) + 1) * ((rings) + 1))
#define QTRI_TORUS_TRIANGLES(slices, rings) (2 * (slices) * (rings))
#define QTRI_GRID_VERTICES(columns, rows)   (((columns) + 1) * ((rows) + 1))
#define QTRI_GRID_TRIANGLES(columns, rows)  (2 * (columns) * (rows))

/* From -half to half; each side has the whole texture. */
enum qtri_error qtri_shape_box(qtri_mesh *mesh, const qtri_shape_memory *memory, qtri_vec3 half);

/* rows 2..1024 from pole to pole. */
enum qtri_error qtri_shape_sphere(qtri_mesh *mesh, const qtri_shape_memory *memory, q16 radius,
                                  int32_t slices, int32_t rows);

/* Closed, from y = -half_height to half_height. A cone ends in its upper point. */
enum qtri_error qtri_shape_cylinder(qtri_mesh *mesh, const qtri_shape_memory *memory, q16 radius,
                                    q16 half_height, int32_t slices);
enum qtri_error qtri_shape_cone(qtri_mesh *mesh, const qtri_shape_memory *memory, q16 radius,
                                q16 half_height, int32_t slices);

/* A tube of radius `tube` around a circle in the plane y = 0; rings 3..1024 around the tube. */
enum qtri_error qtri_shape_torus(qtri_mesh *mesh, const qtri_shape_memory *memory, q16 radius,
                                 q16 tube, int32_t slices, int32_t rings);

/* Of columns x rows fields in the plane y = 0, facing up, from -half to half in x and z; v = 0 at
   -z. columns 1..1024. */
enum qtri_error qtri_shape_grid(qtri_mesh *mesh, const qtri_shape_memory *memory, q16 half_x,
                                q16 half_z, int32_t columns, int32_t rows);

#ifdef __cplusplus
}
#endif

#endif
