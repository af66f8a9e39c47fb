/* SPDX-License-Identifier: MIT */
/*
 * A mesh of the benchmark in both its forms, wide and compact.
 */
#ifndef BENCH_MESH_WRITE_H
#define BENCH_MESH_WRITE_H

#include <stdbool.h>
#include <stdio.h>

#include "../io/obj.h"

/*
 * As C in `out`: bench_mesh_NAME, bench_mesh_NAME_compact, bench_colors_NAME. As OBJ, with the same
 * numbers: FOLDER/NAME.obj and FOLDER/NAME-compact.obj. False, and told, when a file cannot be
 * written.
 */
bool mesh_write(FILE *out, const char *name, const char *folder, const struct obj_mesh *mesh);

/* As C alone, without vertices: for a mesh whose file is not there. */
void mesh_write_empty(FILE *out, const char *name);

#endif
