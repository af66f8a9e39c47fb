/* SPDX-License-Identifier: MIT */
/* Statements about pixels over pixels: blend and fog. */
#include "scene_parser.h"

#define WORD_COUNT(words) ((int)(sizeof(words) / sizeof(words)[0]))

bool scene_statement_blend(struct scene_parser *parser)
{
    static const char *const words[] = {
        [SCENE_BLEND_OFF] = "off",
        [SCENE_BLEND_ALPHA] = "alpha",
        [SCENE_BLEND_ADD] = "add",
        [SCENE_BLEND_MULTIPLY] = "multiply",
        [SCENE_BLEND_NONE] = "none",
        [SCENE_BLEND_REPLACE] = "replace",
        [SCENE_BLEND_SCREENDOOR] = "screendoor",
    };
    struct scene *scene = parser->scene;
    int choice;
    if (!scene_choice(parser, 0, words, WORD_COUNT(words), &choice)) {
        return false;
    }
    scene->blend = (enum scene_blend)choice;
    scene->alpha = 65536;
    return parser->argument_count == 1 || scene_fractions(parser, 1, 1, &scene->alpha);
}

bool scene_statement_colormask(struct scene_parser *parser)
{
    static const char *const words[] = {"off", "on"};
    for (int i = 0; i < 3; i++) {
        int choice;
        if (!scene_choice(parser, i, words, WORD_COUNT(words), &choice)) {
            return false;
        }
        parser->scene->keep[i] = choice == 0;
    }
    return true;
}

bool scene_statement_depthbias(struct scene_parser *parser)
{
    int32_t bias;
    if (!scene_numbers(parser, 0, 1, &bias)) {
        return false;
    }
    if (bias < -65536 || bias > 65536) {
        return scene_fail(parser, "the bias must lie between -1 and 1");
    }
    parser->depth_bias = bias;
    return true;
}

bool scene_statement_depthslope(struct scene_parser *parser)
{
    return scene_numbers(parser, 0, 1, &parser->depth_slope);
}

bool scene_statement_vertexalpha(struct scene_parser *parser)
{
    static const char *const words[] = {"off"};
    int choice;
    parser->by_vertex = parser->argument_count == 3;
    return parser->by_vertex ? scene_fractions(parser, 0, 3, parser->vertex_alpha)
                             : scene_choice(parser, 0, words, 1, &choice);
}

/* Where the range, the colour and `numbers` numbers follow the kind. */
static bool set_fog(struct scene_parser *parser, int numbers)
{
    struct scene_fog *fog = &parser->scene->fog;
    if (!scene_numbers(parser, 1, 2, fog->range) || !scene_fractions(parser, 3, 3, fog->color) ||
        !scene_numbers(parser, 6, numbers, fog->number)) {
        return false;
    }
    return (fog->range[0] > 0 && fog->range[1] > fog->range[0]) ||
           scene_fail(parser, "needs 0 < NEAR < FAR");
}

bool scene_statement_fog(struct scene_parser *parser)
{
    static const char *const words[] = {"off", "linear"};
    int choice;
    if (!scene_choice(parser, 0, words, WORD_COUNT(words), &choice)) {
        return false;
    }
    parser->scene->fog.kind = choice == 0 ? SCENE_FOG_OFF : SCENE_FOG_LINEAR;
    if ((choice == 1) != (parser->argument_count == 8)) {
        return scene_fail(parser, "is `fog off` or `fog linear NEAR FAR r g b START END`");
    }
    return choice == 0 || set_fog(parser, 2);
}

bool scene_statement_fogdensity(struct scene_parser *parser)
{
    static const char *const words[] = {"exp", "exp2"};
    int choice;
    if (!scene_choice(parser, 0, words, WORD_COUNT(words), &choice)) {
        return false;
    }
    parser->scene->fog.kind = choice == 0 ? SCENE_FOG_EXP : SCENE_FOG_EXP2;
    return set_fog(parser, 1);
}
