/* SPDX-License-Identifier: MIT */
/* Statements that are kept in order: matrices, meshes, triangles, lines. */
#include "scene_parser.h"

#include <stdlib.h>
#include <string.h>

#include "array.h"
#include "number.h"

#define DEGREES_180 (180 * SCENE_ONE)

struct scene_op *scene_add_op(struct scene_parser *parser, enum scene_op_kind kind)
{
    struct scene *scene = parser->scene;
    struct scene_op *op =
        array_add(&scene->ops, &scene->op_count, &parser->op_capacity, sizeof *op);
    op->kind = kind;
    op->line = parser->line;
    op->depth_bias = parser->depth_bias;
    op->depth_slope = parser->depth_slope;
    op->by_vertex = parser->by_vertex;
    memcpy(op->vertex_alpha, parser->vertex_alpha, sizeof op->vertex_alpha);
    parser->polyline = NULL;
    return op;
}

/* An operation that is one number. */
static bool add_number(struct scene_parser *parser, enum scene_op_kind kind, int32_t number)
{
    scene_add_op(parser, kind)->u.number[0] = number;
    return true;
}

bool scene_statement_mode(struct scene_parser *parser, const int32_t *value)
{
    parser->mode = value[0];
    return add_number(parser, value[0] == 0 ? SCENE_MODE_PROJECTION : SCENE_MODE_MODELVIEW, 0);
}

/* ---- Statements that are a row of numbers ---- */

static bool is_zero(const int32_t v[3])
{
    return v[0] == 0 && v[1] == 0 && v[2] == 0;
}

/* Each returns what is wrong with the numbers, as they are after rounding to Q16.16, or NULL. */

static const char *lookat_problem(const int32_t *n)
{
    if (memcmp(n, n + 3, 3 * sizeof *n) == 0) {
        return "the eye and the center must differ";
    }
    return is_zero(n + 6) ? "the up vector must not be zero" : NULL;
}

static const char *planes_problem(int32_t near_plane, int32_t far_plane)
{
    if (near_plane <= 0 || far_plane <= 0) {
        return "near and far must be greater than 0";
    }
    return near_plane == far_plane ? "near and far must differ" : NULL;
}

static const char *perspective_problem(const int32_t *n)
{
    if (n[0] <= 0 || n[0] >= DEGREES_180) {
        return "the field of view must lie between 0 and 180 degrees";
    }
    return n[1] <= 0 ? "the aspect must be greater than 0" : planes_problem(n[2], n[3]);
}

static const char *sides_problem(const int32_t *n)
{
    if (n[0] == n[1]) {
        return "left and right must differ";
    }
    return n[2] == n[3] ? "bottom and top must differ" : NULL;
}

static const char *numbers_problem(enum scene_op_kind kind, const int32_t *n)
{
    const char *problem;
    switch (kind) {
    case SCENE_LOOKAT:
    case SCENE_LOOKAT_D3D:
        return lookat_problem(n);
    case SCENE_PERSPECTIVE:
    case SCENE_PERSPECTIVE_D3D:
        return perspective_problem(n);
    case SCENE_FRUSTUM:
    case SCENE_FRUSTUM_D3D:
        problem = sides_problem(n);
        return problem != NULL ? problem : planes_problem(n[4], n[5]);
    case SCENE_ORTHO:
    case SCENE_ORTHO_D3D:
        problem = sides_problem(n);
        return problem == NULL && n[4] == n[5] ? "near and far must differ" : problem;
    case SCENE_ROTATE:
    case SCENE_ROTATE_ABOUT:
        return is_zero(n + 1) ? "the axis must not be zero" : NULL;
    case SCENE_QUATERNION:
        return n[0] == 0 && is_zero(n + 1) ? "the quaternion must not be zero" : NULL;
    default:
        return NULL;
    }
}

/* `into` is the kind of operation. */
bool scene_statement_numbers(struct scene_parser *parser, const int32_t *value)
{
    const enum scene_op_kind kind = (enum scene_op_kind)parser->statement->into;
    const char *problem = numbers_problem(kind, value);
    if (problem != NULL) {
        return scene_fail(parser, problem);
    }
    struct scene_op *op = scene_add_op(parser, kind);
    memcpy(op->u.number, value, sizeof op->u.number);
    return true;
}

bool scene_statement_window(struct scene_parser *parser, const int32_t *value)
{
    struct scene_op *op = scene_add_op(parser, SCENE_WINDOW);
    memcpy(op->u.number, value, 5 * sizeof *value);
    return true;
}

/* ---- Stacks ---- */

bool scene_statement_push(struct scene_parser *parser, const int32_t *value)
{
    (void)value;
    if (parser->depth[parser->mode] == SCENE_STACK_DEPTH) {
        return scene_fail(parser, "nested too deep");
    }
    parser->depth[parser->mode]++;
    return add_number(parser, SCENE_PUSH, 0);
}

bool scene_statement_pop(struct scene_parser *parser, const int32_t *value)
{
    (void)value;
    if (parser->depth[parser->mode] == 0) {
        return scene_fail(parser, "without a push on the same stack");
    }
    parser->depth[parser->mode]--;
    return add_number(parser, SCENE_POP, 0);
}

/* ---- Keys, joints, billboards ---- */

bool scene_statement_key(struct scene_parser *parser, const int32_t *value)
{
    struct scene *scene = parser->scene;
    if (is_zero(value + 5)) {
        return scene_fail(parser, "the axis must not be zero");
    }
    if (parser->track_is_used) {
        parser->track_first = scene->key_count;
        parser->track_is_used = false;
    }
    if (scene->key_count > parser->track_first &&
        value[0] <= scene->keys[scene->key_count - 1].time) {
        return scene_fail(parser, "the time must grow from key to key");
    }
    struct scene_key *key =
        array_add(&scene->keys, &scene->key_count, &parser->key_capacity, sizeof *key);
    key->time = value[0];
    memcpy(key->position, value + 1, sizeof key->position);
    key->degrees = value[4];
    memcpy(key->axis, value + 5, sizeof key->axis);
    memcpy(key->scale, value + 8, sizeof key->scale);
    return true;
}

bool scene_statement_keys(struct scene_parser *parser, const int32_t *value)
{
    const struct scene_track track = {.first = parser->track_first,
                                      .count = parser->scene->key_count - parser->track_first,
                                      .time = value[0]};
    if (track.count == 0) {
        return scene_fail(parser, "without a key before it");
    }
    parser->track_is_used = true;
    scene_add_op(parser, SCENE_KEYS)->u.track = track;
    return true;
}

/* The number of an earlier joint. */
static bool earlier_joint(struct scene_parser *parser, int32_t *joint)
{
    if (parser->joint_count == 0) {
        return scene_fail(parser, "without a joint before it");
    }
    return scene_integer(parser, 0, 0, parser->joint_count - 1, joint);
}

bool scene_statement_joint(struct scene_parser *parser, const int32_t *value)
{
    int32_t parent = -1;
    (void)value;
    if (!token_equals(&parser->arguments[0], "none") && !earlier_joint(parser, &parent)) {
        return false;
    }
    if (parser->joint_count == SCENE_MAX_JOINTS) {
        return scene_fail(parser, "more joints than a scene can have");
    }
    parser->joint_count++;
    return add_number(parser, SCENE_JOINT, parent);
}

bool scene_statement_atjoint(struct scene_parser *parser, const int32_t *value)
{
    int32_t joint = 0;
    (void)value;
    return earlier_joint(parser, &joint) && add_number(parser, SCENE_AT_JOINT, joint);
}

bool scene_statement_camera(struct scene_parser *parser, const int32_t *value)
{
    (void)value;
    parser->has_camera = true;
    return add_number(parser, SCENE_CAMERA, 0);
}

bool scene_statement_billboard(struct scene_parser *parser, const int32_t *value)
{
    (void)value;
    if (!parser->has_camera) {
        return scene_fail(parser, "without a camera before it");
    }
    return add_number(parser, SCENE_BILLBOARD, parser->argument_count);
}

/* ---- Triangles, lines, points ---- */

/* An operation whose `count` triangles, or lines, have ids. */
static struct scene_op *add_with_ids(struct scene_parser *parser, enum scene_op_kind kind,
                                     size_t count)
{
    struct scene *scene = parser->scene;
    if (count > UINT32_MAX - scene->triangle_count) {
        scene_fail(parser, "more triangles than can be numbered");
        return NULL;
    }
    struct scene_op *op = scene_add_op(parser, kind);
    op->id = scene->triangle_count + 1;
    scene->triangle_count += (uint32_t)count;
    return op;
}

/* Position and colour, then texture coordinates and a normal where there are so many values. */
static struct scene_vertex vertex_of(const int32_t *value, int count)
{
    struct scene_vertex vertex = {.uv = {0}};
    const bool textured = count == 9 || count == 12;
    memcpy(vertex.position, value, sizeof vertex.position);
    memcpy(vertex.color, value + 4, sizeof vertex.color);
    if (textured) {
        memcpy(vertex.uv, value + 7, sizeof vertex.uv);
    }
    if (count >= 10) {
        memcpy(vertex.normal, value + (textured ? 9 : 7), sizeof vertex.normal);
    }
    return vertex;
}

bool scene_statement_triangle(struct scene_parser *parser, const int32_t *value)
{
    const int count = parser->argument_count / 3;
    struct scene_op *op = add_with_ids(parser, SCENE_TRIANGLE, 1);
    if (op == NULL) {
        return false;
    }
    op->u.triangle.textured = count == 9 || count == 12;
    for (int i = 0; i < 3; i++) {
        op->u.triangle.vertex[i] = vertex_of(value + i * count, count);
    }
    return true;
}

static bool add_stroke_vertex(struct scene_parser *parser, const int32_t *value)
{
    struct scene *scene = parser->scene;
    struct scene_vertex *vertex = array_add(&scene->stroke_vertices, &scene->stroke_vertex_count,
                                            &parser->stroke_vertex_capacity, sizeof *vertex);
    *vertex = vertex_of(value, 7);
    return true;
}

/* A stroke of the `count` vertices that follow. */
static struct scene_stroke *add_stroke(struct scene_parser *parser, size_t count)
{
    struct scene_op *op = add_with_ids(parser, SCENE_STROKE, 1);
    if (op == NULL) {
        return NULL;
    }
    op->u.stroke = parser->stroke;
    op->u.stroke.first = parser->scene->stroke_vertex_count;
    op->u.stroke.count = count;
    return &op->u.stroke;
}

bool scene_statement_line(struct scene_parser *parser, const int32_t *value)
{
    return add_stroke(parser, 2) != NULL && add_stroke_vertex(parser, value) &&
           add_stroke_vertex(parser, value + 7);
}

bool scene_statement_point(struct scene_parser *parser, const int32_t *value)
{
    struct scene_stroke *stroke = add_stroke(parser, 1);
    if (stroke == NULL) {
        return false;
    }
    stroke->is_point = true;
    stroke->width = parser->point_size;
    stroke->in_space = parser->point_in_space;
    return add_stroke_vertex(parser, value);
}

bool scene_statement_polyline(struct scene_parser *parser, const int32_t *value)
{
    struct scene_stroke *stroke = add_stroke(parser, 0);
    if (stroke == NULL) {
        return false;
    }
    stroke->closed = value[0] == 1;
    parser->polyline = &parser->scene->ops[parser->scene->op_count - 1];
    return true;
}

bool scene_statement_vertex(struct scene_parser *parser, const int32_t *value)
{
    if (parser->polyline == NULL) {
        return scene_fail(parser, "without a polyline before it");
    }
    parser->polyline->u.stroke.count++;
    return add_stroke_vertex(parser, value);
}

/* ---- Meshes: each file is read once ---- */

static bool known_mesh(const struct scene_parser *parser, const struct scene_mesh_file *wanted,
                       size_t *mesh)
{
    for (size_t i = 0; i < parser->scene->mesh_count; i++) {
        const struct scene_mesh_file *known = &parser->mesh_files[i];
        if (known->identity.device == wanted->identity.device &&
            known->identity.number == wanted->identity.number &&
            known->scale.factor == wanted->scale.factor && known->scale.fit == wanted->scale.fit) {
            *mesh = i;
            return true;
        }
    }
    return false;
}

static bool read_mesh(struct scene_parser *parser, const char *path,
                      const struct scene_mesh_file *file, size_t *mesh)
{
    const bool is_scaled = file->scale.factor > 0.0 || file->scale.fit > 0.0;
    struct text_error error;
    if (known_mesh(parser, file, mesh)) {
        return true;
    }
    *mesh = parser->scene->mesh_count;
    parser->scene->meshes = array_grow(parser->scene->meshes, *mesh, &parser->mesh_capacity,
                                       sizeof *parser->scene->meshes);
    parser->mesh_files = array_grow(parser->mesh_files, *mesh, &parser->mesh_file_capacity,
                                    sizeof *parser->mesh_files);
    if (!obj_read_scaled(path, is_scaled ? &file->scale : NULL, &parser->scene->meshes[*mesh],
                         &error)) {
        return scene_fail(parser, error.message);
    }
    parser->mesh_files[*mesh] = *file;
    parser->scene->mesh_count++;
    return true;
}

/* The index in scene->meshes of the file that an argument names, in this scale. */
static bool find_mesh(struct scene_parser *parser, int argument, struct obj_scale scale,
                      size_t *mesh)
{
    struct scene_mesh_file file = {.scale = scale};
    char *path = scene_path(parser, argument, &file.identity);
    const bool found = path != NULL && read_mesh(parser, path, &file, mesh);
    free(path);
    return found;
}

/* Takes `color r g b` off the end of the arguments; false with the error. */
static bool take_color(struct scene_parser *parser, int32_t color[3])
{
    const int rest = parser->argument_count - 4;
    for (int i = 0; i < 3; i++) {
        color[i] = SCENE_ONE;
    }
    if (rest < 1 || !token_equals(&parser->arguments[rest], "color")) {
        return true;
    }
    parser->argument_count = rest;
    return scene_read_values(parser, rest + 1, 3, 'f', color);
}

static bool add_mesh_op(struct scene_parser *parser, enum scene_op_kind kind, size_t index,
                        size_t triangles, const int32_t color[3])
{
    struct scene_op *op = add_with_ids(parser, kind, triangles);
    if (op != NULL) {
        op->u.mesh.mesh = index;
        memcpy(op->u.mesh.color, color, sizeof op->u.mesh.color);
    }
    return op != NULL;
}

/* fit SIZE, or scale FACTOR: in double precision, as the file's positions are multiplied by it. */
static bool read_mesh_scale(struct scene_parser *parser, struct obj_scale *scale)
{
    const struct token *token = &parser->arguments[2];
    const bool fits = token_equals(&parser->arguments[1], "fit");
    double value;
    if (!fits && !scene_word(parser, 1, "scale")) {
        return false;
    }
    if (number_parse_real(token->text, token->length, &value) != NUMBER_OK ||
        value < (fits ? OBJ_FIT_MIN : OBJ_SCALE_MIN) ||
        value > (fits ? OBJ_FIT_MAX : OBJ_SCALE_MAX)) {
        return scene_fail_argument(
            parser, 2, fits ? "is not a size of .001 to 65534" : "is not a factor of 1e-9 to 1e9");
    }
    *(fits ? &scale->fit : &scale->factor) = value;
    return true;
}

bool scene_statement_mesh(struct scene_parser *parser, const int32_t *value)
{
    int32_t color[3];
    struct obj_scale scale = {0.0, 0.0};
    const int given = parser->argument_count;
    size_t mesh;
    (void)value;
    if ((given == 5 || given == 7) && !scene_word(parser, given - 4, "color")) {
        return false;
    }
    if (!take_color(parser, color)) {
        return false;
    }
    if (parser->argument_count != 1 && parser->argument_count != 3) {
        parser->argument_count = given;
        return scene_fail_count(parser);
    }
    return (parser->argument_count == 1 || read_mesh_scale(parser, &scale)) &&
           find_mesh(parser, 0, scale, &mesh) &&
           add_mesh_op(parser, SCENE_MESH, mesh, parser->scene->meshes[mesh].triangle_count, color);
}

/* ---- Models: meshes that are computed, or made of several ---- */

static bool add_model(struct scene_parser *parser, const struct scene_model *model,
                      const int32_t color[3])
{
    struct scene *scene = parser->scene;
    struct scene_model *added =
        array_add(&scene->models, &scene->model_count, &parser->model_capacity, sizeof *added);
    *added = *model;
    return add_mesh_op(parser, SCENE_MODEL, scene->model_count - 1, model->triangles, color);
}

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

/* `into` is the shape; its values are a word, sizes, and counts. */
bool scene_statement_shape(struct scene_parser *parser, const int32_t *value)
{
    static const int sizes[] = {[SCENE_BOX] = 3,  [SCENE_SPHERE] = 1, [SCENE_CYLINDER] = 2,
                                [SCENE_CONE] = 2, [SCENE_TORUS] = 2,  [SCENE_GRID] = 2};
    struct scene_model model = {.kind = SCENE_SHAPE,
                                .shape = (enum scene_shape)parser->statement->into};
    int32_t color[3];
    if (!take_color(parser, color)) {
        return false;
    }
    for (int i = 1; i < parser->argument_count; i++) {
        if (i <= sizes[model.shape]) {
            model.size[i - 1] = value[i];
        } else {
            model.count[i - 1 - sizes[model.shape]] = value[i];
        }
    }
    count_shape(&model);
    if (model.vertices > SCENE_MAX_MODEL_VERTICES) {
        return scene_fail(parser, "more than 65536 vertices");
    }
    return add_model(parser, &model, color);
}

/* Reads the mesh that an argument names into the model's list. */
static bool add_mesh(struct scene_parser *parser, struct scene_model *model, int argument)
{
    const struct obj_scale unscaled = {0.0, 0.0};
    size_t *mesh = &model->mesh[model->mesh_count];
    if (!find_mesh(parser, argument, unscaled, mesh)) {
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

bool scene_statement_morph(struct scene_parser *parser, const int32_t *value)
{
    struct scene_model model = {.kind = SCENE_MORPH, .at = value[0]};
    int32_t color[3];
    return take_color(parser, color) && add_mesh(parser, &model, 1) &&
           add_mesh(parser, &model, 2) && add_model(parser, &model, color);
}

bool scene_statement_frames(struct scene_parser *parser, const int32_t *value)
{
    struct scene_model model = {.kind = SCENE_FRAMES, .at = value[0]};
    int32_t color[3];
    bool ok = take_color(parser, color);
    if (ok && (parser->argument_count < 3 || parser->argument_count > 1 + SCENE_MAX_MODEL_MESHES)) {
        return scene_fail_count(parser);
    }
    for (int i = 1; ok && i < parser->argument_count; i++) {
        ok = add_mesh(parser, &model, i);
    }
    return ok && add_model(parser, &model, color);
}

bool scene_statement_targets(struct scene_parser *parser, const int32_t *value)
{
    struct scene_model model = {.kind = SCENE_TARGETS};
    int32_t color[3];
    bool ok = take_color(parser, color);
    const int count = parser->argument_count;
    (void)value;
    if (ok && (count % 2 == 0 || count > 2 * SCENE_MAX_MODEL_MESHES - 1)) {
        return scene_fail_count(parser);
    }
    ok = ok && add_mesh(parser, &model, 0);
    for (int i = 1; ok && i < count; i += 2) {
        ok = scene_read_values(parser, i, 1, 'n', &model.weight[model.mesh_count]) &&
             add_mesh(parser, &model, i + 1);
    }
    return ok && add_model(parser, &model, color);
}
