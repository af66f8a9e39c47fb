/* SPDX-License-Identifier: MIT */
/*
 * What a model has besides its meshes, as the core takes it: materials, textures, motion. For an
 * asset that asset_make has made of a model with merged materials.
 */
#ifndef QTRI_HOST_ASSETS_ASSET_MODEL_H
#define QTRI_HOST_ASSETS_ASSET_MODEL_H

#include "asset.h"

/* How textures are made: `width` and `height` are the most that they may have. */
bool asset_add_textures(struct asset *asset, const char *path, const struct model *model,
                        const struct texture_options *most, struct text_error *error);

/* Keys, nodes, and the bounds. False with *error set: out of memory, or beyond Q16.16. */
bool asset_add_motion(struct asset *asset, const char *path, const struct model *model,
                      struct text_error *error);

/* The material of a part; its texture is for the caller to set. */
qtri_material asset_material(const struct asset_part *part);

/* Where nodes are at a time, node 0 where `pose` is: node_count transforms, or one. */
void asset_pose(const struct asset *asset, const qtri_transform *pose, q16 time,
                qtri_transform *poses);

/* The weights of all targets at a time, three a track; and a part's positions with them, as many as
   it has vertices. */
void asset_weights(const struct asset *asset, q16 time, q16 *weights);
void asset_shape(const struct asset_part *part, const q16 *weights, qtri_position16 *out);

#endif
