/* SPDX-License-Identifier: MIT */
#include "scene_parser.h"

#include <string.h>

#define WORD_COUNT(words) ((int)(sizeof(words) / sizeof(words)[0]))

static bool is_zero(const int32_t v[3])
{
    return (v[0] | v[1] | v[2]) == 0;
}

static bool numbers_in(struct scene_parser *parser, int first, int count, int32_t *numbers, int low,
                       int high, const char *problem)
{
    if (!scene_numbers(parser, first, count, numbers)) {
        return false;
    }
    for (int i = 0; i < count; i++) {
        if (numbers[i] < low * SCENE_ONE || numbers[i] > high * SCENE_ONE) {
            return scene_fail_argument(parser, first + i, problem);
        }
    }
    return true;
}

static bool light_color(struct scene_parser *parser, int first, int32_t color[3])
{
    return numbers_in(parser, first, 3, color, 0, 16, "does not lie in 0..16");
}

static bool exponent(struct scene_parser *parser, int argument, int32_t *number)
{
    return numbers_in(parser, argument, 1, number, 1, 1024, "does not lie in 1..1024");
}

static bool direction(struct scene_parser *parser, int first, int32_t v[3])
{
    if (!scene_numbers(parser, first, 3, v)) {
        return false;
    }
    return !is_zero(v) || scene_fail(parser, "the direction must not be zero");
}

/* `light x y z ambient diffuse`: the last one counts. */
static bool one_light(struct scene_parser *parser)
{
    struct scene_light *light = &parser->scene->light;
    return direction(parser, 0, light->towards) && scene_fractions(parser, 3, 1, &light->ambient) &&
           scene_fractions(parser, 4, 1, &light->diffuse);
}

/* How a light fades, if the arguments go on. */
static bool fade(struct scene_parser *parser, int first, struct scene_lamp *lamp)
{
    lamp->fade[0] = SCENE_ONE;
    return parser->argument_count == first ||
           numbers_in(parser, first, 3, lamp->fade, 0, 32767, "must not be below 0");
}

static bool spot(struct scene_parser *parser, struct scene_lamp *lamp)
{
    const char *angle = "is not an angle of 0..180 degrees";
    if (!scene_numbers(parser, 1, 3, lamp->position) || !direction(parser, 4, lamp->direction) ||
        !numbers_in(parser, 7, 1, &lamp->inner, 0, 180, angle) ||
        !numbers_in(parser, 8, 1, &lamp->outer, 0, 180, angle) ||
        !light_color(parser, 9, lamp->color) || !fade(parser, 12, lamp)) {
        return false;
    }
    return parser->argument_count < 16 || exponent(parser, 15, &lamp->exponent);
}

static bool has_count(struct scene_parser *parser, int a, int b, int c)
{
    const int count = parser->argument_count;
    return count == a || count == b || count == c || scene_fail_count(parser);
}

/* Each `light` with a kind is one more. */
bool scene_statement_light(struct scene_parser *parser)
{
    static const char *const words[] = {
        [SCENE_DIRECTIONAL] = "directional", [SCENE_POINT] = "point", [SCENE_SPOT] = "spot"};
    struct scene *scene = parser->scene;
    struct scene_lamp lamp;
    int kind;
    bool ok;
    if (parser->argument_count == 5) {
        return one_light(parser);
    }
    memset(&lamp, 0, sizeof lamp);
    if (strchr("+-.0123456789", parser->arguments[0].text[0]) != NULL) {
        return scene_fail_count(parser); /* numbers alone, but not five */
    }
    if (!scene_choice(parser, 0, words, WORD_COUNT(words), &kind)) {
        return false;
    }
    if (scene->lamp_count == SCENE_MAX_LAMPS) {
        return scene_fail(parser, "more lights than can be drawn with");
    }
    lamp.kind = (enum scene_lamp_kind)kind;
    if (lamp.kind == SCENE_DIRECTIONAL) {
        ok = has_count(parser, 7, 7, 7) && direction(parser, 1, lamp.position) &&
             light_color(parser, 4, lamp.color);
    } else if (lamp.kind == SCENE_POINT) {
        ok = has_count(parser, 7, 10, 10) && scene_numbers(parser, 1, 3, lamp.position) &&
             light_color(parser, 4, lamp.color) && fade(parser, 7, &lamp);
    } else {
        ok = has_count(parser, 12, 15, 16) && spot(parser, &lamp);
    }
    if (ok) {
        scene->lamps[scene->lamp_count++] = lamp;
        scene->lamps_on = true;
    }
    return ok;
}

bool scene_statement_ambient(struct scene_parser *parser)
{
    parser->scene->lamps_on = true;
    return light_color(parser, 0, parser->scene->ambient);
}

bool scene_statement_material(struct scene_parser *parser)
{
    static const char *const words[] = {"ambient", "emission", "specular"};
    struct scene_reflection *reflection = &parser->scene->reflection;
    int32_t *const colors[] = {reflection->ambient, reflection->emission, reflection->specular};
    int word;
    if (!scene_choice(parser, 0, words, WORD_COUNT(words), &word)) {
        return false;
    }
    if (parser->argument_count != (word == 2 ? 5 : 4)) {
        return scene_fail_count(parser);
    }
    reflection->own_ambient |= word == 0;
    parser->scene->lamps_on = true;
    return scene_fractions(parser, 1, 3, colors[word]) &&
           (word != 2 || exponent(parser, 4, &reflection->shininess));
}

static bool is_second(struct scene_parser *parser, const char *second, bool *is)
{
    const char *const words[] = {"off", second};
    int choice;
    if (!scene_choice(parser, 0, words, WORD_COUNT(words), &choice)) {
        return false;
    }
    *is = choice == 1;
    return true;
}

bool scene_statement_twosided(struct scene_parser *parser)
{
    return is_second(parser, "on", &parser->scene->reflection.two_sided);
}

bool scene_statement_texgen(struct scene_parser *parser)
{
    return is_second(parser, "sphere", &parser->scene->texture_sphere);
}
