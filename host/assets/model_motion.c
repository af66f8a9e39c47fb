/* SPDX-License-Identifier: MIT */
#include "model_motion.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- Poses between keys ---- */

static void mix(const double *from, const double *to, int count, double t, double *out)
{
    for (int i = 0; i < count; i++) {
        out[i] = from[i] + t * (to[i] - from[i]);
    }
}

/* Along the shortest arc, as qtri_keys_at goes. */
static void slerp(const double from[4], const double to[4], double t, double out[4])
{
    double dot = 0.0, near[4];
    for (int i = 0; i < 4; i++) {
        dot += from[i] * to[i];
    }
    for (int i = 0; i < 4; i++) {
        near[i] = dot < 0.0 ? -to[i] : to[i];
    }
    const double angle = acos(fmin(fabs(dot), 1.0));
    if (angle < 1e-6) {
        mix(from, near, 4, t, out);
        return;
    }
    for (int i = 0; i < 4; i++) {
        out[i] = (sin((1.0 - t) * angle) * from[i] + sin(t * angle) * near[i]) / sin(angle);
    }
}

static struct model_key between(const struct model_key *a, const struct model_key *b, double time)
{
    struct model_key key = *a;
    const double t = b->time > a->time ? (time - a->time) / (b->time - a->time) : 0.0;
    key.time = time;
    mix(a->position, b->position, 3, t, key.position);
    mix(a->scale, b->scale, 3, t, key.scale);
    slerp(a->orientation, b->orientation, t, key.orientation);
    return key;
}

struct model_key motion_key_at(const struct model *model, const struct model_node *node,
                               double time)
{
    const struct model_key *keys = &model->keys[node->first_key];
    size_t i = 0;
    while (i + 1 < node->key_count && keys[i + 1].time <= time) {
        i++;
    }
    if (time <= keys[i].time || i + 1 == node->key_count) {
        return keys[i];
    }
    return between(&keys[i], &keys[i + 1], time);
}

static void matrix_of(const struct model_key *key, double m[3][4])
{
    const double *q = key->orientation;
    const double w = q[0], x = q[1], y = q[2], z = q[3];
    const double turn[3][3] = {{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
                               {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
                               {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}};
    for (int row = 0; row < 3; row++) {
        for (int column = 0; column < 3; column++) {
            m[row][column] = turn[row][column] * key->scale[column];
        }
        m[row][3] = key->position[row];
    }
}

static void multiply(const double a[3][4], const double b[3][4], double out[3][4])
{
    for (int row = 0; row < 3; row++) {
        for (int column = 0; column < 4; column++) {
            out[row][column] = a[row][0] * b[0][column] + a[row][1] * b[1][column] +
                               a[row][2] * b[2][column] + (column == 3 ? a[row][3] : 0.0);
        }
    }
}

void model_pose(const struct model *model, double time, double (*world)[3][4])
{
    memset(world[0], 0, sizeof world[0]);
    for (int i = 0; i < 3; i++) {
        world[0][i][i] = 1.0;
    }
    for (size_t i = 0; i < model->node_count; i++) {
        double local[3][4];
        const struct model_key key = motion_key_at(model, &model->nodes[i], time);
        matrix_of(&key, local);
        multiply((const double(*)[4])world[model->nodes[i].parent], (const double(*)[4])local,
                 world[i + 1]);
    }
}

/* ---- Of the library's channels ---- */

#ifdef QTRI_HAVE_ASSIMP

#include <assimp/cimport.h>
#include <assimp/scene.h>

bool motion_moves(const struct aiNodeAnim *channel)
{
    bool moves = false;
    for (unsigned i = 1; i < channel->mNumPositionKeys; i++) {
        moves = moves || memcmp(&channel->mPositionKeys[i].mValue,
                                &channel->mPositionKeys[0].mValue, sizeof(struct aiVector3D)) != 0;
    }
    for (unsigned i = 1; i < channel->mNumRotationKeys; i++) {
        moves =
            moves || memcmp(&channel->mRotationKeys[i].mValue, &channel->mRotationKeys[0].mValue,
                            sizeof(struct aiQuaternion)) != 0;
    }
    for (unsigned i = 1; i < channel->mNumScalingKeys; i++) {
        moves = moves || memcmp(&channel->mScalingKeys[i].mValue, &channel->mScalingKeys[0].mValue,
                                sizeof(struct aiVector3D)) != 0;
    }
    return moves;
}

static void copy_vector(const struct aiVector3D *from, double to[3])
{
    to[0] = (double)from->x;
    to[1] = (double)from->y;
    to[2] = (double)from->z;
}

static void copy_quaternion(const struct aiQuaternion *from, double to[4])
{
    to[0] = (double)from->w;
    to[1] = (double)from->x;
    to[2] = (double)from->y;
    to[3] = (double)from->z;
}

static void vector_at(const struct aiVectorKey *keys, unsigned count, double time, double out[3])
{
    unsigned i = 0;
    while (i + 1 < count && keys[i + 1].mTime <= time) {
        i++;
    }
    if (count > 0) {
        copy_vector(&keys[i].mValue, out);
    }
    if (i + 1 < count && time > keys[i].mTime) {
        double to[3];
        copy_vector(&keys[i + 1].mValue, to);
        mix(out, to, 3, (time - keys[i].mTime) / (keys[i + 1].mTime - keys[i].mTime), out);
    }
}

static void quaternion_at(const struct aiQuatKey *keys, unsigned count, double time, double out[4])
{
    unsigned i = 0;
    while (i + 1 < count && keys[i + 1].mTime <= time) {
        i++;
    }
    if (count > 0) {
        copy_quaternion(&keys[i].mValue, out);
    }
    if (i + 1 < count && time > keys[i].mTime) {
        double from[4], to[4];
        memcpy(from, out, sizeof from);
        copy_quaternion(&keys[i + 1].mValue, to);
        slerp(from, to, (time - keys[i].mTime) / (keys[i + 1].mTime - keys[i].mTime), out);
    }
}

static void rest_key(const struct aiMatrix4x4 *matrix, struct model_key *key)
{
    struct aiVector3D scale, position;
    struct aiQuaternion orientation;
    aiDecomposeMatrix(matrix, &scale, &orientation, &position);
    memset(key, 0, sizeof *key);
    copy_vector(&scale, key->scale);
    copy_vector(&position, key->position);
    copy_quaternion(&orientation, key->orientation);
}

/* Adds a node with the keys that were appended to the model's last. */
static bool add_node(struct model *model, size_t keys, uint16_t *node, double *factor)
{
    struct model_node *nodes =
        model->node_count < UINT16_MAX
            ? realloc(model->nodes, (model->node_count + 1) * sizeof *model->nodes)
            : NULL;
    if (nodes == NULL) {
        return false;
    }
    model->nodes = nodes;
    const size_t first = model->key_count - keys;
    const double scale = model->keys[first].scale[0];
    bool is_even = scale > 0.0;
    for (size_t i = first; i < model->key_count; i++) {
        for (int j = 0; j < 3; j++) {
            is_even = is_even && fabs(model->keys[i].scale[j] - scale) <= 1e-5 * scale;
            model->keys[i].position[j] *= *factor;
        }
    }
    for (size_t i = first; is_even && i < model->key_count; i++) {
        for (int j = 0; j < 3; j++) {
            model->keys[i].scale[j] = 1.0;
        }
    }
    *factor *= is_even ? scale : 1.0;
    nodes[model->node_count].parent = *node;
    nodes[model->node_count].first_key = first;
    nodes[model->node_count].key_count = keys;
    *node = (uint16_t)++model->node_count;
    return true;
}

struct model_key *motion_append_keys(struct model *model, size_t count)
{
    struct model_key *keys = realloc(model->keys, (model->key_count + count) * sizeof *model->keys);
    if (keys == NULL) {
        return NULL;
    }
    model->keys = keys;
    keys += model->key_count;
    memset(keys, 0, count * sizeof *keys);
    model->key_count += count;
    return keys;
}

/* Scaled alike in all directions, and nothing else. */
static bool is_scale(const struct model_key *key)
{
    const double *p = key->position, *s = key->scale;
    return p[0] == 0.0 && p[1] == 0.0 && p[2] == 0.0 && fabs(key->orientation[0]) >= 1.0 - 1e-12 &&
           s[0] > 0.0 && fabs(s[1] - s[0]) <= 1e-5 * s[0] && fabs(s[2] - s[0]) <= 1e-5 * s[0];
}

bool motion_add_rest(struct model *model, const struct aiMatrix4x4 *matrix, uint16_t *node,
                     double *factor)
{
    struct model_key rest;
    rest_key(matrix, &rest);
    if (is_scale(&rest)) {
        *factor *= rest.scale[0];
        return true;
    }
    struct model_key *key = motion_append_keys(model, 1);
    if (key == NULL) {
        return false;
    }
    *key = rest;
    return add_node(model, 1, node, factor);
}

static int compare_moments(const void *a, const void *b)
{
    const struct motion_moment *x = a;
    const struct motion_moment *y = b;
    return x->time != y->time ? (x->time > y->time) - (x->time < y->time)
                              : (int)y->is_before - (int)x->is_before;
}

/* What moves a node: the library's keys, and curves in the place of some of them. */
struct channel {
    const struct aiNodeAnim *keys;
    const struct motion_curve *curves[MOTION_WEIGHTS]; /* NULL: straight lines between the keys */
};

/* The times at which a channel wants keys, each once; how many there are. NULL: no memory. */
static struct motion_moment *merge_moments(const struct channel *channel, size_t *count)
{
    const struct aiNodeAnim *keys = channel->keys;
    size_t all = (size_t)keys->mNumPositionKeys + keys->mNumRotationKeys + keys->mNumScalingKeys;
    for (int i = 0; i < MOTION_WEIGHTS; i++) {
        all += channel->curves[i] != NULL ? motion_curve_moments(channel->curves[i], NULL) : 0;
    }
    struct motion_moment *moments = calloc(all + 1, sizeof *moments);
    if (moments == NULL) {
        return NULL;
    }
    all = 0;
    for (unsigned i = 0; i < keys->mNumPositionKeys; i++) {
        moments[all++].time = keys->mPositionKeys[i].mTime;
    }
    for (unsigned i = 0; i < keys->mNumRotationKeys; i++) {
        moments[all++].time = keys->mRotationKeys[i].mTime;
    }
    for (unsigned i = 0; i < keys->mNumScalingKeys; i++) {
        moments[all++].time = keys->mScalingKeys[i].mTime;
    }
    for (int i = 0; i < MOTION_WEIGHTS; i++) {
        all += channel->curves[i] != NULL ? motion_curve_moments(channel->curves[i], &moments[all])
                                          : 0;
    }
    qsort(moments, all, sizeof *moments, compare_moments);
    *count = 0;
    for (size_t i = 0; i < all; i++) {
        if (i == 0 || compare_moments(&moments[i], &moments[*count - 1]) != 0) {
            moments[(*count)++] = moments[i];
        }
    }
    return moments;
}

/* *key is at rest. */
static void channel_at(const struct channel *channel, const struct motion_moment *moment,
                       struct model_key *key)
{
    const struct aiNodeAnim *keys = channel->keys;
    double *values[] = {key->position, key->orientation, key->scale};
    vector_at(keys->mPositionKeys, keys->mNumPositionKeys, moment->time, key->position);
    vector_at(keys->mScalingKeys, keys->mNumScalingKeys, moment->time, key->scale);
    quaternion_at(keys->mRotationKeys, keys->mNumRotationKeys, moment->time, key->orientation);
    for (int i = 0; i < MOTION_WEIGHTS; i++) {
        if (channel->curves[i] != NULL) {
            motion_curve_at(channel->curves[i], moment->time, moment->is_before, values[i]);
        }
    }
}

/* Far less than a pixel, or a 16-bit position, shows. */
static bool is_close(const struct model_key *a, const struct model_key *b, double size)
{
    double dot = 0.0, off = 0.0, scale = 0.0;
    for (int i = 0; i < 3; i++) {
        off = fmax(off, fabs(a->position[i] - b->position[i]));
        scale = fmax(scale, fabs(a->scale[i] - b->scale[i]));
    }
    for (int i = 0; i < 4; i++) {
        dot += a->orientation[i] * b->orientation[i];
    }
    return off <= 1e-4 * size && scale <= 1e-4 && fabs(dot) >= 1.0 - 1e-8;
}

size_t motion_thin_keys(struct model_key *keys, size_t count)
{
    double size = 0.0;
    for (size_t i = 1; i < count; i++) {
        for (int j = 0; j < 3; j++) {
            size = fmax(size, fabs(keys[i].position[j] - keys[0].position[j]));
        }
    }
    size_t kept = 1, base = 0; /* base: of the last key that was kept, in the order before */
    for (size_t i = 1; i < count; i++) {
        bool needed = i + 1 == count;
        const struct model_key last = keys[kept - 1];
        for (size_t j = base + 1; !needed && j <= i; j++) {
            const struct model_key made = between(&last, &keys[i + 1], keys[j].time);
            needed = !is_close(&made, &keys[j], size) || i - base > 256;
        }
        if (needed) {
            keys[kept++] = keys[i];
            base = i;
        }
    }
    return kept;
}

bool motion_add_channel(struct model *model, const struct aiAnimation *animation,
                        const struct aiNodeAnim *keys, const struct motion_curves *curves,
                        const struct aiMatrix4x4 *rest, uint16_t *node, double *factor)
{
    const double per_second = animation->mTicksPerSecond > 0.0 ? animation->mTicksPerSecond : 25.0;
    struct channel channel = {.keys = keys};
    size_t count = 0;
    for (int i = 0; i < MOTION_WEIGHTS; i++) {
        channel.curves[i] = motion_curve_of(curves, keys->mNodeName.data, (enum motion_path)i);
    }
    struct motion_moment *moments = merge_moments(&channel, &count);
    struct model_key *made = moments != NULL ? motion_append_keys(model, count) : NULL;
    for (size_t i = 0; made != NULL && i < count; i++) {
        rest_key(rest, &made[i]);
        channel_at(&channel, &moments[i], &made[i]);
        made[i].time = moments[i].time / per_second;
    }
    free(moments);
    if (made == NULL) {
        return false;
    }
    const size_t kept = motion_thin_keys(made, count);
    model->key_count -= count - kept;
    return add_node(model, kept, node, factor);
}

#endif
