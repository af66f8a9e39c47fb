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

#endif
