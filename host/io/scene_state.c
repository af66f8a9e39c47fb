/* SPDX-License-Identifier: MIT */
/* Statements of global state whose values are more than stored: the last of each counts. */
#include "scene_parser.h"

#include <string.h>

/* Words and numbers are stored into enumerations as they are read. */
typedef char an_enumeration_has_the_size_of_a_value[sizeof(enum scene_cull) == 4 ? 1 : -1];

bool scene_statement_viewport(struct scene_parser *parser, const int32_t *value)
{
    if (parser->any_statement) { /* a second viewport is not the first statement either */
        return scene_fail(parser, "must be the first statement");
    }
    parser->scene->width = value[0];
    parser->scene->height = value[1];
    return true;
}

/* ---- Depth ---- */

bool scene_statement_depth(struct scene_parser *parser, const int32_t *value)
{
    parser->scene->depth_test = value[0] > 0; /* `off` is the first word */
    if (value[0] > 0) {
        parser->scene->depth_compare = (enum scene_compare)(value[0] - 1);
    }
    return true;
}

bool scene_statement_depthbias(struct scene_parser *parser, const int32_t *value)
{
    if (value[0] < -SCENE_ONE || value[0] > SCENE_ONE) {
        return scene_fail(parser, "the bias must lie between -1 and 1");
    }
    parser->depth_bias = value[0];
    return true;
}

/* ---- Surfaces ---- */

bool scene_statement_shade(struct scene_parser *parser, const int32_t *value)
{
    parser->scene->flat = value[0] == 1;
    parser->scene->by_pixel = value[0] == 2;
    parser->scene->provoking = value[1] == 1 ? 0 : 2;
    return true;
}

bool scene_statement_polygon(struct scene_parser *parser, const int32_t *value)
{
    enum { FILL, LINE, SMOOTH, WIDE, HIDDEN };
    static const struct scene_stroke thin = {
        .width = SCENE_ONE, .alpha = SCENE_ONE, .cap = SCENE_CAP_BUTT, .smooth = true};
    struct scene *scene = parser->scene;
    if (value[0] != HIDDEN && parser->argument_count == 2) {
        return scene_fail_count(parser);
    }
    scene->wireframe = value[0] != FILL;
    scene->smooth_lines = value[0] == SMOOTH;
    scene->hidden_lines = value[0] == HIDDEN;
    scene->wide_lines = value[0] == WIDE;
    scene->wide = value[0] == SMOOTH ? thin : parser->stroke;
    scene->hidden_bias = parser->argument_count == 2 ? value[1] : 131; /* .002 */
    return true;
}

/* ---- Texels ---- */

/* One word for both directions, or u and v. */
bool scene_statement_texwrap(struct scene_parser *parser, const int32_t *value)
{
    parser->scene->texture_clamp[0] = value[0] == 1;
    parser->scene->texture_clamp[1] = (value[1] > 0 ? value[1] - 1 : value[0]) == 1;
    return true;
}

bool scene_statement_texformat(struct scene_parser *parser, const int32_t *value)
{
    parser->texformat_line = parser->line;
    return scene_store(parser, value);
}

bool scene_statement_texkey(struct scene_parser *parser, const int32_t *value)
{
    parser->texkey_line = parser->line;
    return scene_store_key(parser, value);
}

/* `into`: whether there is one. */
bool scene_statement_alphatest(struct scene_parser *parser, const int32_t *value)
{
    parser->scene->least_alpha = value[0]; /* of `off` 0 */
    parser->alphatest_line = parser->statement->into != 0 ? parser->line : 0;
    return true;
}

/* ---- Alpha and fog ---- */

bool scene_statement_vertexalpha(struct scene_parser *parser, const int32_t *value)
{
    parser->by_vertex = parser->argument_count == 3;
    if (parser->by_vertex) {
        memcpy(parser->vertex_alpha, value, sizeof parser->vertex_alpha);
    }
    return true;
}

/* `into` is the kind of the statement's first word. */
bool scene_statement_fog(struct scene_parser *parser, const int32_t *value)
{
    struct scene_fog *fog = &parser->scene->fog;
    if (value[1] <= 0 || value[2] <= value[1]) {
        return scene_fail(parser, "needs 0 < NEAR < FAR");
    }
    fog->kind = (enum scene_fog_kind)((int32_t)parser->statement->into + value[0]);
    memcpy(fog->range, value + 1, sizeof fog->range);
    memcpy(fog->color, value + 3, sizeof fog->color);
    memcpy(fog->number, value + 6, sizeof fog->number);
    return true;
}

/* ---- Light ---- */

static bool is_direction(struct scene_parser *parser, const int32_t v[3])
{
    return (v[0] | v[1] | v[2]) != 0 || scene_fail(parser, "the direction must not be zero");
}

/* `light x y z ambient diffuse`: the last one counts. */
bool scene_statement_one_light(struct scene_parser *parser, const int32_t *value)
{
    struct scene_light *light = &parser->scene->light;
    memcpy(light->towards, value, sizeof light->towards);
    light->ambient = value[3];
    light->diffuse = value[4];
    return is_direction(parser, value);
}

/* Each `light` with a kind, which is `into`, is one more. */
bool scene_statement_light(struct scene_parser *parser, const int32_t *value)
{
    struct scene *scene = parser->scene;
    struct scene_lamp lamp = {.kind = (enum scene_lamp_kind)parser->statement->into};
    const int32_t *next = value + 4;
    if (scene->lamp_count == SCENE_MAX_LAMPS) {
        return scene_fail(parser, "more lights than can be drawn with");
    }
    memcpy(lamp.position, value + 1, sizeof lamp.position);
    if (lamp.kind == SCENE_SPOT) {
        memcpy(lamp.direction, next, sizeof lamp.direction);
        lamp.inner = next[3];
        lamp.outer = next[4];
        next += 5;
    }
    memcpy(lamp.color, next, sizeof lamp.color);
    if (lamp.kind != SCENE_DIRECTIONAL) {
        lamp.fade[0] = SCENE_ONE;
        if (parser->argument_count > (int)(next + 3 - value)) {
            memcpy(lamp.fade, next + 3, sizeof lamp.fade);
        }
        lamp.exponent = lamp.kind == SCENE_SPOT ? next[6] : 0;
    }
    if ((lamp.kind == SCENE_DIRECTIONAL && !is_direction(parser, lamp.position)) ||
        (lamp.kind == SCENE_SPOT && !is_direction(parser, lamp.direction))) {
        return false;
    }
    scene->lamps[scene->lamp_count++] = lamp;
    scene->lamps_on = true;
    return true;
}

bool scene_statement_ambient(struct scene_parser *parser, const int32_t *value)
{
    memcpy(parser->scene->ambient, value, sizeof parser->scene->ambient);
    parser->scene->lamps_on = true;
    return true;
}

/* `into` is where the colour is stored. */
bool scene_statement_material(struct scene_parser *parser, const int32_t *value)
{
    struct scene_reflection *reflection = &parser->scene->reflection;
    int32_t *color = (void *)((char *)parser->scene + parser->statement->into);
    memcpy(color, value + 1, sizeof reflection->ambient);
    reflection->own_ambient |= color == reflection->ambient;
    if (color == reflection->specular) {
        reflection->shininess = value[4];
    }
    parser->scene->lamps_on = true;
    return true;
}
