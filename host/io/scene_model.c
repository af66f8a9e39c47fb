/* SPDX-License-Identifier: MIT */
/* Statements about meshes that are computed, or made of several. */
#include <string.h>

#include "array.h"
#include "scene_parser.h"

/* The arguments before `color r g b`, which ends them, or all; -1 with the error. */
static int take_color(struct scene_parser *parser, int32_t color[3])
{
    const int count = parser->argument_count;
    for (int i = 0; i < 3; i++) {
        color[i] = SCENE_ONE;
    }
    if (count < 5 || !token_equals(&parser->arguments[count - 4], "color")) {
        return count;
    }
    return scene_fractions(parser, count - 3, 3, color) ? count - 4 : -1;
}

static bool add_model(struct scene_parser *parser, const struct scene_model *model,
                      const int32_t color[3])
{
    struct scene *scene = parser->scene;
    uint32_t id = 0;
    struct scene_model *grown =
        array_grow(scene->models, scene->model_count, &parser->model_capacity, sizeof *grown);
    if (grown == NULL) {
        return scene_fail(parser, "out of memory");
    }
    scene->models = grown;
    if (!scene_take_ids(parser, model->triangles, &id)) {
        return false;
    }
    struct scene_op *op = scene_add_op(parser, SCENE_MODEL);
    if (op == NULL) {
        return false;
    }
    op->id = id;
    op->u.mesh.mesh = scene->model_count;
    memcpy(op->u.mesh.color, color, sizeof op->u.mesh.color);
    grown[scene->model_count++] = *model;
    return true;
}

/* ---- Shapes ---- */

/* Sizes and counts of each, and the least of its first count and second. */
static const struct {
    int sizes, counts, least[2];
} shapes[] = {
    [SCENE_BOX] = {3, 0, {0, 0}},      [SCENE_SPHERE] = {1, 2, {3, 2}},
    [SCENE_CYLINDER] = {2, 1, {3, 0}}, [SCENE_CONE] = {2, 1, {3, 0}},
    [SCENE_TORUS] = {2, 2, {3, 3}},    [SCENE_GRID] = {2, 2, {1, 1}},
};

/* How many vertices and triangles it has; counts are up to 1024. */
static void count_shape(struct scene_model *model)
{
    const uint32_t slices = (uint32_t)model->count[0];
    const uint32_t rows = (uint32_t)model->count[1];
    switch (model->shape) {
    case SCENE_BOX:
        model->vertices = 24;
        model->triangles = 12;
        break;
    case SCENE_CYLINDER:
        model->vertices = 6 * (slices + 1);
        model->triangles = 4 * slices;
        break;
    case SCENE_CONE:
        model->vertices = 4 * (slices + 1);
        model->triangles = 2 * slices;
        break;
    case SCENE_SPHERE:
    case SCENE_TORUS:
    case SCENE_GRID:
        model->vertices = (slices + 1) * (rows + 1);
        model->triangles = 2 * slices * (rows - (model->shape == SCENE_SPHERE));
        break;
    }
}

bool scene_statement_shape(struct scene_parser *parser)
{
    static const char *const words[] = {
        [SCENE_BOX] = "box",   [SCENE_SPHERE] = "sphere", [SCENE_CYLINDER] = "cylinder",
        [SCENE_CONE] = "cone", [SCENE_TORUS] = "torus",   [SCENE_GRID] = "grid"};
    struct scene_model model = {.kind = SCENE_SHAPE};
    int32_t color[3];
    int shape;
    const int count = take_color(parser, color);
    if (count < 0 || !scene_choice(parser, 0, words, 6, &shape)) {
        return false;
    }
    model.shape = (enum scene_shape)shape;
    const int sizes = shapes[shape].sizes;
    if (count != 1 + sizes + shapes[shape].counts) {
        return scene_fail_count(parser);
    }
    if (!scene_numbers(parser, 1, sizes, model.size)) {
        return false;
    }
    for (int i = 0; i < shapes[shape].counts; i++) {
        if (!scene_integer(parser, 1 + sizes + i, shapes[shape].least[i], 1024, &model.count[i])) {
            return false;
        }
    }
    count_shape(&model);
    if (model.vertices > SCENE_MAX_MODEL_VERTICES) {
        return scene_fail(parser, "more than 65536 vertices");
    }
    return add_model(parser, &model, color);
}

/* ---- Of several meshes ---- */

/* Reads the mesh that an argument names into the model's list. */
static bool add_mesh(struct scene_parser *parser, struct scene_model *model, int argument)
{
    size_t *mesh = &model->mesh[model->mesh_count];
    if (!scene_find_mesh(parser, argument, NULL, mesh)) {
        return false;
    }
    const struct obj_mesh *first = &parser->scene->meshes[model->mesh[0]];
    const struct obj_mesh *one = &parser->scene->meshes[*mesh];
    model->mesh_count++;
    if (one->vertex_count > SCENE_MAX_MODEL_VERTICES) {
        return scene_fail_argument(parser, argument, "has more than 65536 vertices");
    }
    if (one->vertex_count != first->vertex_count || one->triangle_count != first->triangle_count ||
        memcmp(one->triangles, first->triangles, one->triangle_count * sizeof *one->triangles) !=
            0) {
        return scene_fail_argument(parser, argument, "has other triangles than the first mesh");
    }
    model->vertices = (uint32_t)first->vertex_count;
    model->triangles = (uint32_t)first->triangle_count;
    return true;
}

bool scene_statement_morph(struct scene_parser *parser)
{
    struct scene_model model = {.kind = SCENE_MORPH};
    int32_t color[3];
    const int count = take_color(parser, color);
    if (count < 0) {
        return false;
    }
    if (count != 3) {
        return scene_fail_count(parser);
    }
    return scene_fractions(parser, 0, 1, &model.at) && add_mesh(parser, &model, 1) &&
           add_mesh(parser, &model, 2) && add_model(parser, &model, color);
}

bool scene_statement_frames(struct scene_parser *parser)
{
    struct scene_model model = {.kind = SCENE_FRAMES};
    int32_t color[3];
    const int count = take_color(parser, color);
    if (count < 0) {
        return false;
    }
    if (count < 3 || count > 1 + SCENE_MAX_MODEL_MESHES) {
        return scene_fail_count(parser);
    }
    bool ok = scene_numbers(parser, 0, 1, &model.at);
    for (int i = 1; ok && i < count; i++) {
        ok = add_mesh(parser, &model, i);
    }
    return ok && add_model(parser, &model, color);
}

bool scene_statement_targets(struct scene_parser *parser)
{
    struct scene_model model = {.kind = SCENE_TARGETS};
    int32_t color[3];
    const int count = take_color(parser, color);
    if (count < 0) {
        return false;
    }
    if (count < 3 || count % 2 == 0 || count > 2 * SCENE_MAX_MODEL_MESHES - 1) {
        return scene_fail_count(parser);
    }
    bool ok = add_mesh(parser, &model, 0);
    for (int i = 1; ok && i < count; i += 2) {
        ok = scene_numbers(parser, i, 1, &model.weight[model.mesh_count]) &&
             add_mesh(parser, &model, i + 1);
    }
    return ok && add_model(parser, &model, color);
}

bool scene_statement_frustumcull(struct scene_parser *parser)
{
    static const char *const words[] = {
        [SCENE_FRUSTUM_OFF] = "off", [SCENE_FRUSTUM_BOX] = "box", [SCENE_FRUSTUM_BALL] = "ball"};
    int choice;
    const bool ok = scene_choice(parser, 0, words, 3, &choice);
    if (ok) {
        parser->scene->frustum_cull = (enum scene_frustum_cull)choice;
    }
    return ok;
}
