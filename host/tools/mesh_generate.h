/* SPDX-License-Identifier: MIT */
/*
 * Meshes of the project's own, generated.
 */
#ifndef QTRI_HOST_TOOLS_MESH_GENERATE_H
#define QTRI_HOST_TOOLS_MESH_GENERATE_H

#include <stdbool.h>
#include <stdio.h>

/* Names that mesh_generate knows, NULL at the end. */
extern const char *const mesh_names[];

/*
 * Writes the mesh `name` as OBJ text, counter-clockwise seen from outside, within about 1.5 of the
 * origin, with normals and texture coordinates but for the gear. False for an unknown name.
 */
bool mesh_generate(const char *name, FILE *out);

/* Faces of rows x columns quads as OBJ text, whose vertices of all attributes stand row by row. */
void mesh_write_quads(FILE *out, int rows, int columns);

#endif
