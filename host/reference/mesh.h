/* SPDX-License-Identifier: MIT */
/*
 * Meshes: the vertex stage, lighting, and assembly into triangles.
 */
#ifndef QTRI_HOST_REFERENCE_MESH_H
#define QTRI_HOST_REFERENCE_MESH_H

#include "matrix.h"
#include "target.h"

/* Draws a triangle the way the target asks for: homogeneous, snapped or as an outline. */
void ref_draw_triangle(struct ref_target *target, const struct ref_triangle *triangle);

/* Transforms, lights and draws the mesh of a SCENE_MESH or SCENE_MODEL operation. */
void ref_draw_mesh(struct ref_target *target, const struct scene_op *op,
                   const struct ref_matrix *projection, const struct ref_matrix *modelview);

#endif
