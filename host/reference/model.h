/* SPDX-License-Identifier: MIT */
/*
 * The meshes of a scene in double precision: read from files, computed, or mixed of several.
 */
#ifndef QTRI_HOST_REFERENCE_MODEL_H
#define QTRI_HOST_REFERENCE_MODEL_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "../io/scene.h"

struct ref_model {
    double (*positions)[3], (*normals)[3], (*uvs)[2]; /* uvs may be NULL */
    const uint8_t (*colors)[3];                       /* the scene's, or NULL */
    uint32_t (*triangles)[3];
    size_t vertex_count, triangle_count;
};

/*
 * What a SCENE_MESH or SCENE_MODEL operation draws. Meshes that are mixed have normals of 8 bits,
 * round(127 n), as displays store them; what is mixed of these is not rounded.
 */
void ref_model_create(struct ref_model *model, const struct scene *scene,
                      const struct scene_op *op);
void ref_model_free(struct ref_model *model);

/* Fills a model that has room for it with a computed shape. */
void ref_shape(struct ref_model *model, const struct scene_model *shape);

#endif
