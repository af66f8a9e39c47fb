/* SPDX-License-Identifier: MIT */
#include "scene_transform.h"

#include <stdlib.h>

#include "../io/xalloc.h"

#include "scene_color.h"

static void load(qtri_transform *out, const int32_t number[16])
{
    qtri_mat4 m;
    for (int column = 0; column < 4; column++) {
        for (int row = 0; row < 4; row++) {
            m.m[row][column] = number[4 * column + row];
        }
    }
    qtri_transform_from_mat4(out, &m);
}

static void rotate_triangle(qtri_transform *current, const int32_t *n)
{
    const qtri_vec3 v[3] = {scene_vec3(n + 1), scene_vec3(n + 4), scene_vec3(n + 7)};
    qtri_transform_rotate_triangle(current, n[0], v);
}

/* Turns and moves. */
static void apply_pose(qtri_transform *current, const struct scene_op *op)
{
    const int32_t *n = op->u.number;
    const qtri_quat orientation = {n[0], n[1], n[2], n[3]};
    switch (op->kind) {
    case SCENE_TRANSLATE:
        qtri_transform_translate(current, scene_vec3(n));
        break;
    case SCENE_ROTATE:
        qtri_transform_rotate(current, n[0], scene_vec3(n + 1));
        break;
    case SCENE_SCALE:
        qtri_transform_scale(current, scene_vec3(n));
        break;
    case SCENE_ROTATE_ABOUT:
        qtri_transform_rotate_about(current, n[0], scene_vec3(n + 1), scene_vec3(n + 4));
        break;
    case SCENE_ROTATE_TRIANGLE:
        rotate_triangle(current, n);
        break;
    case SCENE_QUATERNION:
        qtri_transform_rotate_quat(current, orientation);
        break;
    default:
        break;
    }
}

/* Cameras and projections. */
static void apply_view(qtri_transform *current, const struct scene_op *op)
{
    const int32_t *n = op->u.number;
    switch (op->kind) {
    case SCENE_LOOKAT:
        qtri_transform_look_at(current, scene_vec3(n), scene_vec3(n + 3), scene_vec3(n + 6));
        break;
    case SCENE_LOOKAT_D3D:
        qtri_transform_look_at_d3d(current, scene_vec3(n), scene_vec3(n + 3), scene_vec3(n + 6));
        break;
    case SCENE_ORBIT:
        qtri_transform_orbit(current, scene_vec3(n), n[3], n[4], n[5]);
        break;
    case SCENE_PERSPECTIVE:
        qtri_transform_perspective(current, n[0], n[1], n[2], n[3]);
        break;
    case SCENE_PERSPECTIVE_D3D:
        qtri_transform_perspective_d3d(current, n[0], n[1], n[2], n[3]);
        break;
    case SCENE_FRUSTUM:
        qtri_transform_frustum(current, n[0], n[1], n[2], n[3], n[4], n[5]);
        break;
    case SCENE_FRUSTUM_D3D:
        qtri_transform_frustum_d3d(current, n[0], n[1], n[2], n[3], n[4], n[5]);
        break;
    case SCENE_ORTHO:
        qtri_transform_ortho(current, n[0], n[1], n[2], n[3], n[4], n[5]);
        break;
    case SCENE_ORTHO_D3D:
        qtri_transform_ortho_d3d(current, n[0], n[1], n[2], n[3], n[4], n[5]);
        break;
    default:
        apply_pose(current, op);
        break;
    }
}

static void apply_keys(qtri_transform *current, const struct scene *scene,
                       const struct scene_track *track)
{
    qtri_key *keys = xcalloc(track->count, sizeof *keys);
    for (size_t i = 0; i < track->count; i++) {
        const struct scene_key *from = &scene->keys[track->first + i];
        keys[i].time = from->time;
        keys[i].position = scene_vec3(from->position);
        keys[i].orientation = qtri_quat_from_axis_deg(scene_vec3(from->axis), from->degrees);
        keys[i].scale = scene_vec3(from->scale);
    }
    const qtri_key key = qtri_keys_at(keys, (int32_t)track->count, track->time);
    qtri_transform_key(current, &key);
    free(keys);
}

static void apply_joint(struct scene_stacks *stacks, qtri_transform *current, int32_t joint)
{
    qtri_poses_compose(stacks->composed, stacks->joint, stacks->parent, stacks->joint_count);
    qtri_transform_mul(current, current, &stacks->composed[joint]);
}

void scene_stacks_begin(struct scene_stacks *stacks)
{
    stacks->current = 1;
    qtri_transform_identity(&stacks->matrix[0][0]);
    qtri_transform_identity(&stacks->matrix[1][0]);
    qtri_transform_identity(&stacks->camera);
}

void scene_stacks_apply(struct scene_stacks *stacks, const struct scene *scene,
                        const struct scene_op *op)
{
    int *top = &stacks->top[stacks->current];
    qtri_transform *current = &stacks->matrix[stacks->current][*top];
    const int32_t *n = op->u.number;
    qtri_transform given;
    switch (op->kind) {
    case SCENE_MODE_PROJECTION:
        stacks->current = 0;
        break;
    case SCENE_MODE_MODELVIEW:
        stacks->current = 1;
        break;
    case SCENE_PUSH:
        current[1] = current[0];
        (*top)++;
        break;
    case SCENE_POP:
        (*top)--;
        break;
    case SCENE_IDENTITY:
        qtri_transform_identity(current);
        break;
    case SCENE_LOAD:
        load(current, n);
        break;
    case SCENE_MULT:
        load(&given, n);
        qtri_transform_mul(current, current, &given);
        break;
    case SCENE_ORTHONORMALIZE:
        qtri_transform_orthonormalize(current);
        break;
    case SCENE_CAMERA:
        stacks->camera = *current;
        break;
    case SCENE_BILLBOARD:
        (n[0] != 0 ? qtri_transform_billboard_upright : qtri_transform_billboard)(current,
                                                                                  &stacks->camera);
        break;
    case SCENE_KEYS:
        apply_keys(current, scene, &op->u.track);
        break;
    case SCENE_JOINT:
        stacks->joint[stacks->joint_count] = *current;
        stacks->parent[stacks->joint_count++] = (int16_t)n[0];
        break;
    case SCENE_AT_JOINT:
        apply_joint(stacks, current, n[0]);
        break;
    default:
        apply_view(current, op);
        break;
    }
}
