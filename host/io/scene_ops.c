/* SPDX-License-Identifier: MIT */
#include "scene_parser.h"

#include <string.h>

#include "array.h"
#include "number.h"

#define DEGREES_180 (180 * SCENE_ONE)

struct scene_op *scene_add_op(struct scene_parser *parser, enum scene_op_kind kind)
{
    struct scene *scene = parser->scene;
    struct scene_op *grown =
        array_grow(scene->ops, scene->op_count, &parser->op_capacity, sizeof *grown);
    if (grown == NULL) {
        scene_fail(parser, "out of memory");
        return NULL;
    }
    scene->ops = grown;
    struct scene_op *op = &grown[scene->op_count++];
    memset(op, 0, sizeof *op);
    op->kind = kind;
    op->line = parser->line;
    op->depth_bias = parser->depth_bias;
    op->depth_slope = parser->depth_slope;
    op->by_vertex = parser->by_vertex;
    memcpy(op->vertex_alpha, parser->vertex_alpha, sizeof op->vertex_alpha);
    parser->polyline = NULL;
    return op;
}

bool scene_statement_mode(struct scene_parser *parser)
{
    static const char *const words[] = {"projection", "modelview"};
    if (!scene_choice(parser, 0, words, 2, &parser->mode)) {
        return false;
    }
    return scene_add_op(parser, parser->mode == 0 ? SCENE_MODE_PROJECTION : SCENE_MODE_MODELVIEW) !=
           NULL;
}

/* ---- Statements that are a row of numbers ---- */

bool scene_is_zero(const int32_t v[3])
{
    return v[0] == 0 && v[1] == 0 && v[2] == 0;
}

/* Each returns what is wrong with the numbers, as they are after rounding to Q16.16, or NULL. */

static const char *lookat_problem(const int32_t *n)
{
    if (memcmp(n, n + 3, 3 * sizeof *n) == 0) {
        return "the eye and the center must differ";
    }
    return scene_is_zero(n + 6) ? "the up vector must not be zero" : NULL;
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
        return scene_is_zero(n + 1) ? "the axis must not be zero" : NULL;
    case SCENE_QUATERNION:
        return n[0] == 0 && scene_is_zero(n + 1) ? "the quaternion must not be zero" : NULL;
    default:
        return NULL;
    }
}

bool scene_statement_numbers(struct scene_parser *parser)
{
    int32_t numbers[16] = {0};
    enum scene_op_kind kind = parser->statement->kind;
    if (!scene_numbers(parser, 0, parser->argument_count, numbers)) {
        return false;
    }
    const char *problem = numbers_problem(kind, numbers);
    if (problem != NULL) {
        return scene_fail(parser, problem);
    }
    struct scene_op *op = scene_add_op(parser, kind);
    if (op == NULL) {
        return false;
    }
    memcpy(op->u.number, numbers, sizeof numbers);
    return true;
}

/* ---- Stacks ---- */

bool scene_statement_push(struct scene_parser *parser)
{
    if (parser->depth[parser->mode] == SCENE_STACK_DEPTH) {
        return scene_fail(parser, "nested too deep");
    }
    parser->depth[parser->mode]++;
    return scene_add_op(parser, SCENE_PUSH) != NULL;
}

bool scene_statement_pop(struct scene_parser *parser)
{
    if (parser->depth[parser->mode] == 0) {
        return scene_fail(parser, "without a push on the same stack");
    }
    parser->depth[parser->mode]--;
    return scene_add_op(parser, SCENE_POP) != NULL;
}

/* ---- Geometry ---- */

bool scene_take_ids(struct scene_parser *parser, size_t count, uint32_t *id)
{
    uint32_t used = parser->scene->triangle_count;
    if (count > UINT32_MAX - used) {
        return scene_fail(parser, "more triangles than can be numbered");
    }
    *id = used + 1;
    parser->scene->triangle_count = used + (uint32_t)count;
    return true;
}

bool scene_read_vertex(struct scene_parser *parser, int first, bool textured, bool normal,
                       struct scene_vertex *vertex)
{
    return scene_numbers(parser, first, 4, vertex->position) &&
           scene_fractions(parser, first + 4, 3, vertex->color) &&
           (!textured || scene_numbers(parser, first + 7, 2, vertex->uv)) &&
           (!normal || scene_numbers(parser, first + (textured ? 9 : 7), 3, vertex->normal));
}

bool scene_statement_triangle(struct scene_parser *parser)
{
    struct scene_vertex vertex[3];
    int per_vertex = parser->argument_count / 3; /* 7, 2 for texture coordinates, 3 for normals */
    bool textured = per_vertex == 9 || per_vertex == 12;
    bool normal = per_vertex >= 10;
    memset(vertex, 0, sizeof vertex);
    for (int i = 0; i < 3; i++) {
        if (!scene_read_vertex(parser, i * per_vertex, textured, normal, &vertex[i])) {
            return false;
        }
    }
    uint32_t id = 0;
    struct scene_op *op =
        scene_take_ids(parser, 1, &id) ? scene_add_op(parser, SCENE_TRIANGLE) : NULL;
    if (op == NULL) {
        return false;
    }
    op->id = id;
    memcpy(op->u.triangle.vertex, vertex, sizeof vertex);
    op->u.triangle.textured = textured;
    return true;
}

/* fit SIZE, or scale FACTOR: in double precision, as the file's positions are multiplied by it. */
static bool read_mesh_scale(struct scene_parser *parser, struct obj_scale *scale)
{
    static const char *const words[] = {"fit", "scale"};
    static const double least[] = {OBJ_FIT_MIN, OBJ_SCALE_MIN};
    static const double most[] = {OBJ_FIT_MAX, OBJ_SCALE_MAX};
    const struct token *token = &parser->arguments[2];
    int choice;
    double value;
    if (!scene_choice(parser, 1, words, 2, &choice)) {
        return false;
    }
    if (number_parse_real(token->text, token->length, &value) != NUMBER_OK ||
        value < least[choice] || value > most[choice]) {
        return scene_fail_argument(parser, 2,
                                   choice == 0 ? "is not a size of .001 to 65534"
                                               : "is not a factor of 1e-9 to 1e9");
    }
    scale->fit = choice == 0 ? value : 0.0;
    scale->factor = choice == 1 ? value : 0.0;
    return true;
}

bool scene_statement_mesh(struct scene_parser *parser)
{
    int32_t color[3] = {SCENE_ONE, SCENE_ONE, SCENE_ONE};
    struct obj_scale scale = {0.0, 0.0};
    int next = 1;
    if (parser->argument_count % 2 == 0) {
        return scene_fail_count(parser);
    }
    if (parser->argument_count == 3 || parser->argument_count == 7) {
        if (!read_mesh_scale(parser, &scale)) {
            return false;
        }
        next = 3;
    }
    if (parser->argument_count > next) {
        static const char *const words[] = {"color"};
        int choice;
        if (!scene_choice(parser, next, words, 1, &choice) ||
            !scene_fractions(parser, next + 1, 3, color)) {
            return false;
        }
    }
    size_t mesh;
    uint32_t id = 0;
    if (!scene_find_mesh(parser, 0, &scale, &mesh) ||
        !scene_take_ids(parser, parser->scene->meshes[mesh].triangle_count, &id)) {
        return false;
    }
    struct scene_op *op = scene_add_op(parser, SCENE_MESH);
    if (op == NULL) {
        return false;
    }
    op->id = id;
    op->u.mesh.mesh = mesh;
    memcpy(op->u.mesh.color, color, sizeof color);
    return true;
}
