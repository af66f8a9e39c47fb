/* SPDX-License-Identifier: MIT */
#include <string.h>

#include "array.h"
#include "scene_parser.h"

void scene_stroke_defaults(struct scene_parser *parser)
{
    struct scene_stroke line = {.width = SCENE_ONE, .alpha = SCENE_ONE, .smooth = true};
    parser->line_state = line;
    parser->point_state = line;
    parser->point_state.is_point = true;
    parser->point_state.width = 4 * SCENE_ONE;
}

bool scene_statement_linewidth(struct scene_parser *parser)
{
    return scene_numbers(parser, 0, 1, &parser->line_state.width);
}

/* What holds for lines and points. */
static void share(struct scene_parser *parser)
{
    parser->point_state.smooth = parser->line_state.smooth;
    parser->point_state.cap = parser->line_state.cap;
    parser->point_state.alpha = parser->line_state.alpha;
}

bool scene_statement_linesmooth(struct scene_parser *parser)
{
    static const char *const words[] = {"off", "on"};
    int choice;
    if (!scene_choice(parser, 0, words, 2, &choice)) {
        return false;
    }
    parser->line_state.smooth = choice == 1;
    share(parser);
    return true;
}

bool scene_statement_linecap(struct scene_parser *parser)
{
    static const char *const words[] = {
        [SCENE_CAP_ROUND] = "round", [SCENE_CAP_BUTT] = "butt", [SCENE_CAP_SQUARE] = "square"};
    int choice;
    if (!scene_choice(parser, 0, words, 3, &choice)) {
        return false;
    }
    parser->line_state.cap = (enum scene_cap)choice;
    share(parser);
    return true;
}

bool scene_statement_linealpha(struct scene_parser *parser)
{
    const bool ok = scene_fractions(parser, 0, 1, &parser->line_state.alpha);
    share(parser);
    return ok;
}

bool scene_statement_pointsize(struct scene_parser *parser)
{
    static const char *const words[] = {"space"};
    int choice;
    parser->point_state.in_space = parser->argument_count == 2;
    return scene_numbers(parser, 0, 1, &parser->point_state.width) &&
           (parser->argument_count == 1 || scene_choice(parser, 1, words, 1, &choice));
}

/* Appends the vertex whose numbers begin with argument `first`. */
static bool add_vertex(struct scene_parser *parser, int first)
{
    struct scene *scene = parser->scene;
    struct scene_vertex *grown = array_grow(scene->stroke_vertices, scene->stroke_vertex_count,
                                            &parser->stroke_vertex_capacity, sizeof *grown);
    if (grown == NULL) {
        return scene_fail(parser, "out of memory");
    }
    scene->stroke_vertices = grown;
    struct scene_vertex *vertex = &grown[scene->stroke_vertex_count];
    memset(vertex, 0, sizeof *vertex);
    if (!scene_read_vertex(parser, first, false, false, vertex)) {
        return false;
    }
    scene->stroke_vertex_count++;
    return true;
}

/* A stroke of the vertices that follow, with an id as triangles have one. */
static struct scene_op *begin(struct scene_parser *parser, const struct scene_stroke *state)
{
    uint32_t id = 0;
    struct scene_op *op =
        scene_take_ids(parser, 1, &id) ? scene_add_op(parser, SCENE_STROKE) : NULL;
    if (op != NULL) {
        op->id = id;
        op->u.stroke = *state;
        op->u.stroke.first = parser->scene->stroke_vertex_count;
    }
    return op;
}

bool scene_statement_line(struct scene_parser *parser)
{
    struct scene_op *op = begin(parser, &parser->line_state);
    if (op == NULL) {
        return false;
    }
    op->u.stroke.count = 2;
    return add_vertex(parser, 0) && add_vertex(parser, 7);
}

bool scene_statement_point(struct scene_parser *parser)
{
    struct scene_op *op = begin(parser, &parser->point_state);
    if (op == NULL) {
        return false;
    }
    op->u.stroke.count = 1;
    return add_vertex(parser, 0);
}

bool scene_statement_polyline(struct scene_parser *parser)
{
    static const char *const words[] = {"open", "closed"};
    int choice;
    if (!scene_choice(parser, 0, words, 2, &choice)) {
        return false;
    }
    struct scene_op *op = begin(parser, &parser->line_state);
    if (op == NULL) {
        return false;
    }
    op->u.stroke.closed = choice == 1;
    parser->polyline = op;
    return true;
}

bool scene_statement_vertex(struct scene_parser *parser)
{
    struct scene_op *op = parser->polyline;
    if (op == NULL) {
        return scene_fail(parser, "without a polyline before it");
    }
    op->u.stroke.count++;
    return add_vertex(parser, 0);
}
