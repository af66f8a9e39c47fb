/* SPDX-License-Identifier: MIT */
/*
 * Neighbours of a mesh's triangles, see qtri_mesh in mesh.h.
 */
#ifndef QTRI_HOST_TOOLS_MESH_NEIGHBOURS_H
#define QTRI_HOST_TOOLS_MESH_NEIGHBOURS_H

#include <stdbool.h>

#include <qtri.h>

/*
 * Fills neighbours[triangle_count] for the mesh's positions and triangles and names them in
 * mesh->neighbours. Two triangles are neighbours where they have an edge in opposite directions
 * between the same positions: seams of normals or texture coordinates are none. Where more than two
 * triangles meet in an edge, pairs are made in the order of the mesh.
 * False where the mesh has more than 65535 triangles: it has no neighbours then.
 */
bool mesh_neighbours_make(qtri_mesh *mesh, uint16_t (*neighbours)[3]);

/* Gives a mesh its neighbours in memory that is to be freed with it. */
bool mesh_neighbours_add(qtri_mesh *mesh);

#endif
