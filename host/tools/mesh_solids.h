/* SPDX-License-Identifier: MIT */
/*
 * The generated meshes that are not tubes, each as OBJ text.
 */
#ifndef QTRI_HOST_TOOLS_MESH_SOLIDS_H
#define QTRI_HOST_TOOLS_MESH_SOLIDS_H

#include <stdio.h>

void mesh_solid_cube(FILE *out);     /* side 2, a whole texture on each face */
void mesh_solid_sphere(FILE *out);   /* radius 1, 32 x 16 fields, poles at +-y */
void mesh_solid_cylinder(FILE *out); /* radius 1, y from -1 to 1, 32 sides */
void mesh_solid_cone(FILE *out);     /* radius 1 at y = -1, its tip at y = 1, 32 sides */
void mesh_solid_grid(FILE *out); /* side 2 in the plane y = 0, 16 x 16 fields, seen from above */

/*
 * A gear of 21 teeth with a recess on either side, on its shaft along z: without normals, lit face
 * by face, it is 500 vertices and 996 triangles. Two closed surfaces, one of them with a bore, have
 * V = F / 2 + 2.
 */
void mesh_solid_gear(FILE *out);

#endif
