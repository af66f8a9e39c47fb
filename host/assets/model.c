/* SPDX-License-Identifier: MIT */
#include "model.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../io/file.h"
#include "../io/file_identity.h"
#include "../io/unique.h"
#include "../io/xalloc.h"

bool model_create(struct model *model, size_t vertices, size_t triangles, size_t materials)
{
    memset(model, 0, sizeof *model);
    model->vertices = calloc(vertices + 1, sizeof *model->vertices);
    model->triangles = calloc(triangles + 1, sizeof *model->triangles);
    model->materials = calloc(materials + 1, sizeof *model->materials);
    if (model->vertices == NULL || model->triangles == NULL || model->materials == NULL) {
        model_free(model);
        return false;
    }
    model->vertex_count = vertices;
    model->triangle_count = triangles;
    model->material_count = materials;
    for (size_t i = 0; i < materials; i++) {
        memset(model->materials[i].color, 255, sizeof model->materials[i].color);
        model->materials[i].opacity = 255;
    }
    return true;
}

void model_free(struct model *model)
{
    free(model->vertices);
    free(model->triangles);
    free(model->materials);
    for (size_t i = 0; model->pictures != NULL && i < model->picture_count; i++) {
        free(model->pictures[i].bytes);
    }
    free(model->pictures);
    free(model->nodes);
    free(model->keys);
    free(model->morphs);
    free(model->tracks);
    free(model->shifts);
    memset(model, 0, sizeof *model);
}

/* ---- What a file may hold ---- */

static bool is_in_range(const double *numbers, int count)
{
    for (int i = 0; i < count; i++) {
        if (!(fabs(numbers[i]) <= MODEL_MAX_VALUE)) { /* NaN too */
            return false;
        }
    }
    return true;
}

static void normalise(double vector[3])
{
    double length = sqrt(vector[0] * vector[0] + vector[1] * vector[1] + vector[2] * vector[2]);
    for (int axis = 0; axis < 3; axis++) {
        vector[axis] = length > 0.0 ? vector[axis] / length : 0.0;
    }
}

/* Texture coordinates that are no place of a picture become 0, and count as lost. */
static bool check_vertex(struct model_vertex *vertex, size_t *lost)
{
    if (!is_in_range(vertex->position, 3) || !is_in_range(vertex->normal, 3)) {
        return false;
    }
    if (!(fabs(vertex->uv[0]) <= MODEL_MAX_UV && fabs(vertex->uv[1]) <= MODEL_MAX_UV)) {
        vertex->uv[0] = 0.0;
        vertex->uv[1] = 0.0;
        (*lost)++;
    }
    normalise(vertex->normal);
    for (int i = 0; i < 3; i++) { /* -0 becomes 0: they are the same place */
        vertex->position[i] += 0.0;
        vertex->normal[i] += 0.0;
        vertex->uv[i % 2] += 0.0;
    }
    return true;
}

static bool check_shifts(const struct model *model)
{
    bool ok = true;
    for (size_t i = 0; ok && i < model->shift_count; i++) {
        ok = is_in_range(model->shifts[i], 3);
    }
    return ok;
}

static bool check_key(struct model_key *key)
{
    double length = 0.0;
    for (int i = 0; i < 4; i++) {
        length += key->orientation[i] * key->orientation[i];
    }
    for (int i = 0; i < 4; i++) {
        key->orientation[i] = length > 0.0 ? key->orientation[i] / sqrt(length) : i == 0;
    }
    return is_in_range(&key->time, 1) && is_in_range(key->position, 3) &&
           is_in_range(key->scale, 3) && is_in_range(key->orientation, 4);
}

bool model_check(const char *path, struct model *model, struct text_error *error)
{
    for (size_t i = 0; i < model->key_count; i++) {
        if (!check_key(&model->keys[i])) {
            return text_error_set(error, path, 0,
                                  "a key of its animation is not a number, or beyond 1e9");
        }
    }
    if (!check_shifts(model)) {
        return text_error_set(error, path, 0, "a morph target is not a number, or beyond 1e9");
    }
    size_t lost = 0;
    for (size_t i = 0; i < model->vertex_count; i++) {
        if (!check_vertex(&model->vertices[i], &lost) ||
            model->vertices[i].material >= model->material_count ||
            model->vertices[i].node > model->node_count) {
            return text_error_set(error, path, 0, "vertex %zu is not a number, or beyond 1e9",
                                  i + 1);
        }
    }
    model_leave_out(model, lost, "vertex's texture coordinates beyond 32767",
                    "vertices' texture coordinates beyond 32767");
    for (size_t i = 0; i < model->triangle_count; i++) {
        const uint32_t *corner = model->triangles[i];
        for (int j = 0; j < 3; j++) {
            if (corner[j] >= model->vertex_count) {
                return text_error_set(error, path, 0,
                                      "triangle %zu names a vertex that is not there", i + 1);
            }
        }
    }
    return true;
}

/* ---- One vertex for all that are equal ---- */

static bool has_area(const struct model *model, const uint32_t triangle[3])
{
    double edge[2][3];
    for (int axis = 0; axis < 3; axis++) {
        double first = model->vertices[triangle[0]].position[axis];
        edge[0][axis] = model->vertices[triangle[1]].position[axis] - first;
        edge[1][axis] = model->vertices[triangle[2]].position[axis] - first;
    }
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3, k = (i + 2) % 3;
        if (edge[0][j] * edge[1][k] != edge[0][k] * edge[1][j]) {
            return true;
        }
    }
    return false;
}

/* model_check has left no NaN and no -0, so that bytes tell whether numbers are equal. */
void model_weld(struct model *model)
{
    struct unique kept = {.item_size = sizeof *model->vertices};
    size_t count = 0;
    for (size_t i = 0; i < model->triangle_count; i++) {
        const uint32_t *t = model->triangles[i];
        const bool is_kept = has_area(model, t);
        for (int j = 0; is_kept && j < 3; j++) {
            model->triangles[count][j] = unique_add(&kept, &model->vertices[t[j]]);
        }
        count += is_kept ? 1 : 0;
    }
    free(model->vertices);
    model->vertices = kept.items;
    model->vertex_count = kept.count;
    model->triangle_count = count;
    kept.items = NULL;
    unique_free(&kept);
}

/* ---- Where it stands ---- */

static void extend(struct model_box *box, const double at[3], bool is_first)
{
    for (int axis = 0; axis < 3; axis++) {
        box->low[axis] = is_first || at[axis] < box->low[axis] ? at[axis] : box->low[axis];
        box->high[axis] = is_first || at[axis] > box->high[axis] ? at[axis] : box->high[axis];
    }
}

struct model_box model_vertex_bounds(const struct model *model)
{
    struct model_box box = {{0, 0, 0}, {0, 0, 0}};
    for (size_t i = 0; i < model->vertex_count; i++) {
        double low[3], high[3];
        model_shape_bounds(model, &model->vertices[i], low, high);
        extend(&box, low, i == 0);
        extend(&box, high, false);
    }
    return box;
}

void model_vertex_at(const double world[3][4], const struct model_vertex *vertex, double at[3])
{
    const double *p = vertex->position;
    for (int i = 0; i < 3; i++) {
        at[i] = world[i][0] * p[0] + world[i][1] * p[1] + world[i][2] * p[2] + world[i][3];
    }
}

struct model_box model_bounds(const struct model *model)
{
    struct model_box box = {{0, 0, 0}, {0, 0, 0}};
    double(*world)[3][4] = xcalloc(model->node_count + 1, sizeof *world);
    model_pose(model, 0.0, world);
    for (size_t i = 0; i < model->vertex_count; i++) {
        double at[3];
        model_vertex_at((const double(*)[4])world[model->vertices[i].node], &model->vertices[i],
                        at);
        extend(&box, at, i == 0);
    }
    free(world);
    return box;
}

static void turn(double vector[3])
{
    double y = vector[1];
    vector[1] = vector[2];
    vector[2] = 0.0 - y; /* never -0 */
}

/* A quarter about x, before what it is: (1, -1, 0, 0) / sqrt(2) times q. */
static void turn_quaternion(double q[4])
{
    const double w = q[0], x = q[1], y = q[2], z = q[3], half = sqrt(0.5);
    q[0] = half * (w + x);
    q[1] = half * (x - w);
    q[2] = half * (y + z);
    q[3] = half * (z - y);
}

/* As the model was read, no two vertices share their shifts. */
static void turn_shifts(struct model *model, const struct model_vertex *vertex)
{
    const uint32_t count = vertex->morph > 0 ? model->morphs[vertex->morph - 1].target_count : 0;
    for (uint32_t i = 0; i < count; i++) {
        turn(model->shifts[vertex->shift + i]);
    }
}

/* Whether a key moves its node in the space of the model. */
static bool is_topmost(const struct model_node *node)
{
    return node->parent == 0;
}

void model_turn_up(struct model *model, char up)
{
    if (up != 'z') {
        return;
    }
    for (size_t i = 0; i < model->vertex_count; i++) {
        if (model->vertices[i].node == 0) {
            turn(model->vertices[i].position);
            turn(model->vertices[i].normal);
            turn_shifts(model, &model->vertices[i]);
        }
    }
    for (size_t i = 0; i < model->node_count; i++) {
        const struct model_node *node = &model->nodes[i];
        for (size_t j = 0; is_topmost(node) && j < node->key_count; j++) {
            turn(model->keys[node->first_key + j].position);
            turn_quaternion(model->keys[node->first_key + j].orientation);
        }
    }
}

void model_center(struct model *model)
{
    struct model_box box = model_bounds(model);
    for (int axis = 0; axis < 3; axis++) {
        const double middle = (box.low[axis] + box.high[axis]) / 2.0;
        for (size_t i = 0; i < model->vertex_count; i++) {
            model->vertices[i].position[axis] -= model->vertices[i].node == 0 ? middle : 0.0;
        }
        for (size_t i = 0; i < model->node_count; i++) {
            const struct model_node *node = &model->nodes[i];
            for (size_t j = 0; is_topmost(node) && j < node->key_count; j++) {
                model->keys[node->first_key + j].position[axis] -= middle;
            }
        }
    }
}

void model_scale(struct model *model, double factor)
{
    for (int axis = 0; axis < 3; axis++) {
        for (size_t i = 0; i < model->vertex_count; i++) {
            model->vertices[i].position[axis] *= factor;
        }
        for (size_t i = 0; i < model->shift_count; i++) {
            model->shifts[i][axis] *= factor;
        }
        for (size_t i = 0; i < model->node_count; i++) {
            const struct model_node *node = &model->nodes[i];
            for (size_t j = 0; j < node->key_count; j++) {
                model->keys[node->first_key + j].position[axis] *= factor;
            }
        }
    }
}

void model_fit(struct model *model, double size)
{
    struct model_box box = model_bounds(model);
    double largest = 0.0;
    for (int axis = 0; axis < 3; axis++) {
        largest = fmax(largest, box.high[axis] - box.low[axis]);
    }
    if (largest > 0.0) {
        model_scale(model, size / largest);
    }
}

/* Whether there is such a file; then it is the material's. */
static bool take_picture(struct model_material *material, const char *beside, const char *name)
{
    char path[sizeof material->texture];
    if (!file_path_beside(path, sizeof path, beside, name) ||
        file_inspect(path, NULL) == FILE_MISSING) {
        return false;
    }
    memcpy(material->texture, path, sizeof path);
    return true;
}

void model_picture_beside(struct model *model, struct model_material *material, const char *beside,
                          const char *name)
{
    const char *slash = strrchr(name, '/');
    if (!take_picture(material, beside, name) &&
        (slash == NULL || !take_picture(material, beside, slash + 1))) {
        char words[200];
        (void)snprintf(words, sizeof words, "the picture %.150s, which is not there", name);
        if (strstr(model->left_out, words) == NULL) {
            model_leave_out_words(model, words);
        }
    }
}

void model_leave_out_words(struct model *model, const char *words)
{
    const size_t length = strlen(model->left_out);
    (void)snprintf(model->left_out + length, sizeof model->left_out - length, "%s%s",
                   length > 0 && words[0] != '\0' ? ", " : "", words);
}

void model_leave_out(struct model *model, size_t count, const char *one, const char *many)
{
    char words[100];
    if (count > 0) {
        (void)snprintf(words, sizeof words, "%zu %s", count, count == 1 ? one : many);
        model_leave_out_words(model, words);
    }
}
