/* SPDX-License-Identifier: MIT */
/*
 * Planes of a mesh's faces, see qtri_faces in mesh.h.
 */
#ifndef QTRI_HOST_TOOLS_MESH_FACES_H
#define QTRI_HOST_TOOLS_MESH_FACES_H

#include <stdbool.h>

#include <qtri.h>

/*
 * Fills planes[triangle_count] and mesh->faces; the mesh has its positions and triangles, and if it
 * is wide it is given an origin and an extent. How much of a face's direction its 8 bits keep is
 * balanced over the mesh for a view of it about 200 pixels wide. Returns the share of its faces
 * that their planes cull there, over all directions: up to 1/2 of a closed mesh.
 */
double mesh_faces_fill(qtri_mesh *mesh, qtri_face8 *planes);

/*
 * The same where planes save more than they cost: not for small meshes, not for those that are
 * open and mostly seen from the front. Otherwise false, and mesh->faces.planes stays NULL.
 */
bool mesh_faces_make(qtri_mesh *mesh, qtri_face8 *planes);

/* Gives a mesh such planes, in memory that is to be freed with it, where they pay. */
void mesh_faces_add(qtri_mesh *mesh);

#endif
