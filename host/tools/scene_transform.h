/* SPDX-License-Identifier: MIT */
/*
 * Matrix statements of a scene, carried out with the core's transforms.
 */
#ifndef QTRI_HOST_TOOLS_SCENE_TRANSFORM_H
#define QTRI_HOST_TOOLS_SCENE_TRANSFORM_H

#include <qtri.h>

#include "../io/scene.h"

/* What stands while a scene is replayed. */
struct scene_stacks {
    qtri_transform matrix[2][SCENE_STACK_DEPTH + 1];
    int top[2];
    int current;           /* 0 projection, 1 modelview */
    qtri_transform camera; /* of billboards */
    qtri_transform joint[SCENE_MAX_JOINTS], composed[SCENE_MAX_JOINTS];
    int16_t parent[SCENE_MAX_JOINTS];
    int32_t joint_count;
};

/* All as at the beginning of a scene; `stacks` comes all zero. */
void scene_stacks_begin(struct scene_stacks *stacks);

/* Carries out an operation before SCENE_TRIANGLE, but for SCENE_WINDOW. */
void scene_stacks_apply(struct scene_stacks *stacks, const struct scene *scene,
                        const struct scene_op *op);

#endif
