/* SPDX-License-Identifier: MIT */
/*
 * Nodes that move: key frames of a model, of what the library assimp has read.
 */
#ifndef QTRI_HOST_ASSETS_MODEL_MOTION_H
#define QTRI_HOST_ASSETS_MODEL_MOTION_H

#include "model.h"
#include "model_curves.h"

/* What node or track, which are of the model's keys, have at a time. */
struct model_key motion_key_at(const struct model *model, const struct model_node *node,
                               double time);

/* Room for so many more keys, zeroed; NULL when memory runs out. */
struct model_key *motion_append_keys(struct model *model, size_t count);

/* Leaves out keys that their neighbours make as well, as tools write one for each frame; returns
   how many are left. */
size_t motion_thin_keys(struct model_key *keys, size_t count);

struct aiNodeAnim;
struct aiAnimation;
struct aiMatrix4x4;

/* Whether a channel's keys differ. */
bool motion_moves(const struct aiNodeAnim *channel);

/*
 * Adds a node below *node, which becomes the new one: one at rest, or one that moves as a channel
 * says. *factor is how much larger the space of the node is than in the file: a node that is scaled
 * alike in all directions at all times is not, but what is in its space is larger by so much, as
 * small numbers have few digits in Q16.16. False when memory runs out, or beyond 65535 nodes.
 */
bool motion_add_rest(struct model *model, const struct aiMatrix4x4 *matrix, uint16_t *node,
                     double *factor);
bool motion_add_channel(struct model *model, const struct aiAnimation *animation,
                        const struct aiNodeAnim *channel, const struct motion_curves *curves,
                        const struct aiMatrix4x4 *rest, uint16_t *node, double *factor);

#endif
