/* SPDX-License-Identifier: MIT */
/* Statements about poses that are more than a row of numbers: keys, joints, billboards, windows. */
#include <string.h>

#include "array.h"
#include "scene_parser.h"

/* ---- Keys ---- */

bool scene_statement_key(struct scene_parser *parser)
{
    struct scene *scene = parser->scene;
    int32_t n[11];
    if (!scene_numbers(parser, 0, 11, n)) {
        return false;
    }
    if (scene_is_zero(n + 5)) {
        return scene_fail(parser, "the axis must not be zero");
    }
    if (parser->track_is_used) {
        parser->track_first = scene->key_count;
        parser->track_is_used = false;
    }
    if (scene->key_count > parser->track_first && n[0] <= scene->keys[scene->key_count - 1].time) {
        return scene_fail(parser, "the time must grow from key to key");
    }
    struct scene_key *grown =
        array_grow(scene->keys, scene->key_count, &parser->key_capacity, sizeof *grown);
    if (grown == NULL) {
        return scene_fail(parser, "out of memory");
    }
    scene->keys = grown;
    struct scene_key *key = &grown[scene->key_count++];
    key->time = n[0];
    memcpy(key->position, n + 1, sizeof key->position);
    key->degrees = n[4];
    memcpy(key->axis, n + 5, sizeof key->axis);
    memcpy(key->scale, n + 8, sizeof key->scale);
    return true;
}

bool scene_statement_keys(struct scene_parser *parser)
{
    struct scene_track track = {.first = parser->track_first};
    track.count = parser->scene->key_count - parser->track_first;
    if (track.count == 0) {
        return scene_fail(parser, "without a key before it");
    }
    if (!scene_numbers(parser, 0, 1, &track.time)) {
        return false;
    }
    parser->track_is_used = true;
    struct scene_op *op = scene_add_op(parser, SCENE_KEYS);
    if (op != NULL) {
        op->u.track = track;
    }
    return op != NULL;
}

/* ---- Joints ---- */

static bool add_number(struct scene_parser *parser, enum scene_op_kind kind, int32_t number)
{
    struct scene_op *op = scene_add_op(parser, kind);
    if (op != NULL) {
        op->u.number[0] = number;
    }
    return op != NULL;
}

/* The number of an earlier joint. */
static bool earlier_joint(struct scene_parser *parser, int *joint)
{
    if (parser->joint_count == 0) {
        return scene_fail(parser, "without a joint before it");
    }
    return scene_integer(parser, 0, 0, parser->joint_count - 1, joint);
}

bool scene_statement_joint(struct scene_parser *parser)
{
    int parent = -1;
    if (!token_equals(&parser->arguments[0], "none") && !earlier_joint(parser, &parent)) {
        return false;
    }
    if (parser->joint_count == SCENE_MAX_JOINTS) {
        return scene_fail(parser, "more joints than a scene can have");
    }
    parser->joint_count++;
    return add_number(parser, SCENE_JOINT, parent);
}

bool scene_statement_atjoint(struct scene_parser *parser)
{
    int joint = 0;
    return earlier_joint(parser, &joint) && add_number(parser, SCENE_AT_JOINT, joint);
}

/* ---- Billboards ---- */

bool scene_statement_camera(struct scene_parser *parser)
{
    parser->has_camera = true;
    return scene_add_op(parser, SCENE_CAMERA) != NULL;
}

bool scene_statement_billboard(struct scene_parser *parser)
{
    static const char *const words[] = {"upright"};
    int choice;
    if (parser->argument_count == 1 && !scene_choice(parser, 0, words, 1, &choice)) {
        return false;
    }
    if (!parser->has_camera) {
        return scene_fail(parser, "without a camera before it");
    }
    return add_number(parser, SCENE_BILLBOARD, parser->argument_count);
}

/* ---- Windows ---- */

bool scene_statement_window(struct scene_parser *parser)
{
    static const char *const words[] = {"bottom"};
    int n[4];
    int choice;
    for (int i = 0; i < 4; i++) {
        if (!scene_integer(parser, i, i < 2 ? -SCENE_MAX_SIZE : 1, SCENE_MAX_SIZE, &n[i])) {
            return false;
        }
    }
    if (parser->argument_count == 5 && !scene_choice(parser, 4, words, 1, &choice)) {
        return false;
    }
    struct scene_op *op = scene_add_op(parser, SCENE_WINDOW);
    if (op == NULL) {
        return false;
    }
    for (int i = 0; i < 4; i++) {
        op->u.number[i] = n[i];
    }
    op->u.number[4] = parser->argument_count == 5;
    return true;
}
