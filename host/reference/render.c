/* SPDX-License-Identifier: MIT */
/*
 * Replays a scene: two matrix stacks, and the geometry where it stands.
 */
#include "reference.h"
#include "blend.h"
#include "clip.h"
#include "light.h"
#include "matrix.h"
#include "mesh.h"
#include "pose.h"
#include "raster.h"
#include "raster_stroke.h"
#include "paint.h"
#include "samples.h"

#include <assert.h>
#include <math.h>

struct stack {
    struct ref_matrix matrix[SCENE_STACK_DEPTH + 1];
    int top;
};

struct replay {
    struct ref_target target;
    struct ref_matrix camera; /* of billboards */
    struct ref_matrix joint[SCENE_MAX_JOINTS];
    int joint_count;
    struct stack projection, modelview;
    struct stack *current;
};

static void multiply_current(struct replay *replay, struct ref_matrix right)
{
    struct ref_matrix *top = &replay->current->matrix[replay->current->top];
    *top = ref_matrix_multiply(top, &right);
}

/* The parser guarantees that the stacks neither overflow nor underflow. */
static void push(struct stack *stack)
{
    assert(stack->top < SCENE_STACK_DEPTH);
    stack->matrix[stack->top + 1] = stack->matrix[stack->top];
    stack->top++;
}

static void pop(struct stack *stack)
{
    assert(stack->top > 0);
    stack->top--;
}

/* Colours of a single triangle in the scene's lights: by its corners' normals or its own. */
static void light_single(const struct replay *replay, const struct scene_op *op,
                         const struct ref_lighting *light, struct ref_triangle *triangle)
{
    const struct scene *scene = replay->target.scene;
    const int32_t *towards = scene->light.towards;
    double p[3][3], face[3], middle[3];
    bool turned = scene->reflection.two_sided && ref_facing(triangle) < 0;

    if (!scene->lamps_on && (towards[0] | towards[1] | towards[2]) == 0)
        return;
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            p[i][k] = (double)op->u.triangle.vertex[i].position[k] /
                      (double)op->u.triangle.vertex[i].position[3];
    for (int k = 0; k < 3; k++)
        middle[k] = (p[0][k] + p[1][k] + p[2][k]) / 3.0;
    ref_face_normal(p[0], p[1], p[2], face);
    triangle->by_pixel = scene->by_pixel ? light : NULL;
    for (int i = 0; i < 3; i++) {
        const struct scene_vertex *in = &op->u.triangle.vertex[i];
        const struct scene_vertex *colored =
            scene->flat ? &op->u.triangle.vertex[scene->provoking] : in;
        bool own = !scene->flat && (in->normal[0] | in->normal[1] | in->normal[2]) != 0;
        double n[3], color[3];

        for (int k = 0; k < 3; k++) {
            n[k] = (own ? (double)in->normal[k] : face[k]) * (turned ? -1.0 : 1.0);
            color[k] = ref_unit_from_q16(colored->color[k]);
        }
        if (scene->by_pixel)
            ref_light_by_pixel(light, n, p[i], color, triangle->vertex[i].attribute);
        else
            ref_illuminate(light, n, scene->flat ? middle : p[i], color,
                           triangle->vertex[i].attribute);
    }
}

static void draw_single(struct replay *replay, const struct scene_op *op)
{
    const struct scene *scene = replay->target.scene;
    struct ref_matrix to_clip =
        ref_matrix_multiply(&replay->projection.matrix[replay->projection.top],
                            &replay->modelview.matrix[replay->modelview.top]);
    struct ref_triangle triangle = {
        .id = op->id,
        .textured = op->u.triangle.textured && scene->texture.width != 0,
    };

    for (int i = 0; i < 3; i++) {
        const struct scene_vertex *in = &op->u.triangle.vertex[i];
        const struct scene_vertex *colored =
            scene->flat ? &op->u.triangle.vertex[scene->provoking] : in;
        triangle.vertex[i] = ref_vertex_of(&to_clip, in, colored->color);
        triangle.vertex[i].attribute[REF_ALPHA] = ref_vertex_alpha(scene, op, (size_t)i);
    }
    struct ref_lighting light =
        ref_lighting_of(scene, &replay->projection.matrix[replay->projection.top],
                        &replay->modelview.matrix[replay->modelview.top]);
    light_single(replay, op, &light, &triangle);
    ref_draw_triangle(&replay->target, &triangle);
}

/* A joint's pose in its parent's frame is the matrix that stands there. */
static void add_joint(struct replay *replay, int32_t parent)
{
    struct ref_matrix pose = replay->current->matrix[replay->current->top];

    assert(replay->joint_count < SCENE_MAX_JOINTS && parent < replay->joint_count);
    if (parent >= 0)
        pose = ref_matrix_multiply(&replay->joint[parent], &pose);
    replay->joint[replay->joint_count++] = pose;
}

static void set_window(struct replay *replay, const int32_t n[5])
{
    int height = replay->target.scene->height;

    replay->target.window =
        (struct ref_window){n[0], n[4] != 0 ? height - n[1] - n[3] : n[1], n[2], n[3]};
}

/* What a statement multiplies the current matrix with; the identity for those that do not. */
static struct ref_matrix matrix_of(const struct replay *replay, const struct scene_op *op)
{
    const int32_t *number = op->u.number;
    double n[16];

    if (op->kind == SCENE_KEYS)
        return ref_matrix_keys(&replay->target.scene->keys[op->u.track.first], op->u.track.count,
                               op->u.track.time);
    ref_from_q16(number, 16, n);
    switch (op->kind) {
    case SCENE_MULT:
        return ref_matrix_load(number);
    case SCENE_LOOKAT:
        return ref_matrix_look_at(&n[0], &n[3], &n[6]);
    case SCENE_PERSPECTIVE:
        return ref_matrix_perspective(n[0], n[1], n[2], n[3]);
    case SCENE_FRUSTUM:
        return ref_matrix_frustum(n);
    case SCENE_ORTHO:
        return ref_matrix_ortho(n);
    case SCENE_TRANSLATE:
        return ref_matrix_translate(n);
    case SCENE_ROTATE:
        return ref_matrix_rotate(n[0], &n[1]);
    case SCENE_SCALE:
        return ref_matrix_scale(n);
    case SCENE_ROTATE_ABOUT:
        return ref_matrix_rotate_about(n[0], &n[1], &n[4]);
    case SCENE_ROTATE_TRIANGLE:
        return ref_matrix_rotate_triangle(n[0], &n[1]);
    case SCENE_QUATERNION:
        return ref_matrix_quaternion(n);
    case SCENE_ORBIT:
        return ref_matrix_orbit(&n[0], n[3], n[4], n[5]);
    case SCENE_LOOKAT_D3D:
        return ref_matrix_look_at_d3d(&n[0], &n[3], &n[6]);
    case SCENE_PERSPECTIVE_D3D:
        return ref_matrix_perspective_d3d(n[0], n[1], n[2], n[3]);
    case SCENE_FRUSTUM_D3D:
        return ref_matrix_frustum_d3d(n);
    case SCENE_ORTHO_D3D:
        return ref_matrix_ortho_d3d(n);
    case SCENE_BILLBOARD:
        return ref_matrix_billboard(&replay->camera, number[0] != 0);
    case SCENE_AT_JOINT:
        return replay->joint[number[0]];
    default:
        return ref_matrix_identity();
    }
}

static void replay_op(struct replay *replay, const struct scene_op *op)
{
    struct ref_matrix *top = &replay->current->matrix[replay->current->top];

    ref_target_bias(&replay->target, op->depth_bias);
    replay->target.depth_slope = op->depth_slope / 65536.0;
    switch (op->kind) {
    case SCENE_MODE_PROJECTION:
        replay->current = &replay->projection;
        break;
    case SCENE_MODE_MODELVIEW:
        replay->current = &replay->modelview;
        break;
    case SCENE_IDENTITY:
        *top = ref_matrix_identity();
        break;
    case SCENE_LOAD:
        *top = ref_matrix_load(op->u.number);
        break;
    case SCENE_ORTHONORMALIZE:
        *top = ref_matrix_orthonormalized(top);
        break;
    case SCENE_CAMERA:
        replay->camera = *top;
        break;
    case SCENE_JOINT:
        add_joint(replay, op->u.number[0]);
        break;
    case SCENE_WINDOW:
        set_window(replay, op->u.number);
        break;
    case SCENE_PUSH:
        push(replay->current);
        break;
    case SCENE_POP:
        pop(replay->current);
        break;
    case SCENE_TRIANGLE:
        draw_single(replay, op);
        break;
    case SCENE_PAINT:
        ref_paint(&replay->target, &op->u.paint);
        break;
    case SCENE_MESH:
    case SCENE_MODEL:
        ref_draw_mesh(&replay->target, op, &replay->projection.matrix[replay->projection.top],
                      &replay->modelview.matrix[replay->modelview.top]);
        break;
    case SCENE_STROKE:
        ref_draw_stroke(&replay->target, op, &replay->projection.matrix[replay->projection.top],
                        &replay->modelview.matrix[replay->modelview.top]);
        break;
    default:
        multiply_current(replay, matrix_of(replay, op));
        break;
    }
}

static void replay_pass(struct replay *replay, const struct scene *scene)
{
    replay->target.scene = scene;
    replay->camera = ref_matrix_identity();
    replay->joint_count = 0;
    replay->projection.top = 0;
    replay->projection.matrix[0] = ref_matrix_identity();
    replay->modelview.top = 0;
    replay->modelview.matrix[0] = ref_matrix_identity();
    replay->current = &replay->modelview;
    for (size_t i = 0; i < scene->op_count; i++)
        replay_op(replay, &scene->ops[i]);
}

bool ref_render_at(const struct scene *scene, int subpixel_bits, const struct ref_sampling *at,
                   struct reference_image *image)
{
    struct replay replay;

    assert(subpixel_bits >= 0 && subpixel_bits <= 16);
    if (!ref_target_open(&replay.target, scene, subpixel_bits, image))
        return false;
    replay.target.at = *at;
    const struct ref_window whole = replay.target.window;
    for (; scene != NULL; scene = scene->next) {
        replay.target.window = whole;
        replay_pass(&replay, scene);
    }
    return true;
}
