/* SPDX-License-Identifier: MIT */
/*
 * Morph targets of what the library assimp has read.
 */
#ifndef QTRI_HOST_ASSETS_MODEL_MORPH_H
#define QTRI_HOST_ASSETS_MODEL_MORPH_H

#include "model.h"
#include "model_curves.h"

struct aiMesh;
struct aiMeshMorphAnim;

/* How many targets a mesh has; 0 where they are not of all of its vertices. */
unsigned morph_targets(const struct aiMesh *mesh);

/* Adds a morph with the mesh's weights at rest, or those of a channel, or of a curve. False when
   memory runs out. */
bool morph_add(struct model *model, const struct aiMesh *mesh,
               const struct aiMeshMorphAnim *channel, const struct motion_curve *curve,
               double per_second);

/* Memory for the mesh's targets; false where there is none, or too much in all. */
bool morph_reserve(struct model *model, const struct aiMesh *mesh);

/* Gives a vertex the shifts of all targets of the last morph, turned and scaled by a matrix. */
void morph_copy(struct model *model, const struct aiMesh *mesh, unsigned at,
                const double matrix[3][3], struct model_vertex *vertex);

#endif
