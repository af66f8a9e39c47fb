/* SPDX-License-Identifier: MIT */
#include "scene_parser.h"

#define WORD_COUNT(words) ((int)(sizeof(words) / sizeof(words)[0]))

bool scene_statement_viewport(struct scene_parser *parser)
{
    if (parser->any_statement) { /* a second viewport is not the first statement either */
        return scene_fail(parser, "must be the first statement");
    }
    return scene_integer(parser, 0, 1, SCENE_MAX_SIZE, &parser->scene->width) &&
           scene_integer(parser, 1, 1, SCENE_MAX_SIZE, &parser->scene->height);
}

bool scene_statement_clear(struct scene_parser *parser)
{
    return scene_fractions(parser, 0, 3, parser->scene->clear);
}

bool scene_statement_cleardepth(struct scene_parser *parser)
{
    return scene_fractions(parser, 0, 1, &parser->scene->clear_depth);
}

bool scene_statement_depth(struct scene_parser *parser)
{
    static const char *const words[] = {
        [SCENE_LESS] = "less",         [SCENE_LEQUAL] = "lequal", [SCENE_GREATER] = "greater",
        [SCENE_GEQUAL] = "gequal",     [SCENE_ALWAYS] = "always", [SCENE_EQUAL] = "equal",
        [SCENE_NOTEQUAL] = "notequal", [SCENE_NEVER] = "never",   [SCENE_NEVER + 1] = "off",
    };
    int choice;
    if (!scene_choice(parser, 0, words, WORD_COUNT(words), &choice)) {
        return false;
    }
    parser->scene->depth_test = choice <= SCENE_NEVER;
    if (parser->scene->depth_test) {
        parser->scene->depth_compare = (enum scene_compare)choice;
    }
    return true;
}

bool scene_statement_depthformat(struct scene_parser *parser)
{
    static const char *const words[] = {[SCENE_LINEAR16] = "linear16",
                                        [SCENE_FLOAT16] = "float16",
                                        [SCENE_LINEAR24] = "linear24",
                                        [SCENE_LINEAR32] = "linear32"};
    int choice;
    if (!scene_choice(parser, 0, words, WORD_COUNT(words), &choice)) {
        return false;
    }
    parser->scene->depth_format = (enum scene_depth_format)choice;
    return true;
}

/* For statements that choose between two words: whether it is the second one. */
static bool second_word(struct scene_parser *parser, int argument, const char *first,
                        const char *second, bool *is_second)
{
    const char *const words[] = {first, second};
    int choice;
    if (!scene_choice(parser, argument, words, WORD_COUNT(words), &choice)) {
        return false;
    }
    *is_second = choice == 1;
    return true;
}

bool scene_statement_depthmask(struct scene_parser *parser)
{
    return second_word(parser, 0, "off", "on", &parser->scene->depth_write);
}

bool scene_statement_depthrange(struct scene_parser *parser)
{
    return scene_fractions(parser, 0, 1, &parser->scene->depth_near) &&
           scene_fractions(parser, 1, 1, &parser->scene->depth_far);
}

bool scene_statement_cull(struct scene_parser *parser)
{
    static const char *const words[] = {
        [SCENE_CULL_NONE] = "none", [SCENE_CULL_BACK] = "back", [SCENE_CULL_FRONT] = "front"};
    int choice;
    if (!scene_choice(parser, 0, words, WORD_COUNT(words), &choice)) {
        return false;
    }
    parser->scene->cull = (enum scene_cull)choice;
    return true;
}

bool scene_statement_shade(struct scene_parser *parser)
{
    static const char *const words[] = {"smooth", "flat", "pixel"};
    bool last = true;
    int choice;
    if (!scene_choice(parser, 0, words, WORD_COUNT(words), &choice) ||
        (parser->argument_count == 2 && !second_word(parser, 1, "first", "last", &last))) {
        return false;
    }
    parser->scene->flat = choice == 1;
    parser->scene->by_pixel = choice == 2;
    parser->scene->provoking = last ? 2 : 0;
    return true;
}

bool scene_statement_texmode(struct scene_parser *parser)
{
    bool modulate;
    if (!second_word(parser, 0, "replace", "modulate", &modulate)) {
        return false;
    }
    parser->scene->texture_mode = modulate ? SCENE_MODULATE : SCENE_REPLACE;
    return true;
}

/* One word for both directions, or u and v. */
bool scene_statement_texwrap(struct scene_parser *parser)
{
    bool *clamp = parser->scene->texture_clamp;
    if (!second_word(parser, 0, "repeat", "clamp", &clamp[0])) {
        return false;
    }
    clamp[1] = clamp[0];
    return parser->argument_count == 1 || second_word(parser, 1, "repeat", "clamp", &clamp[1]);
}

bool scene_statement_texfilter(struct scene_parser *parser)
{
    static const char *const words[] = {"mipmaps"};
    int choice;
    parser->scene->texture_mipmapped = parser->argument_count == 2;
    return second_word(parser, 0, "nearest", "bilinear", &parser->scene->texture_bilinear) &&
           (parser->argument_count == 1 ||
            scene_choice(parser, 1, words, WORD_COUNT(words), &choice));
}

bool scene_statement_texformat(struct scene_parser *parser)
{
    static const char *const words[] = {
        [SCENE_TEXEL_XRGB8888] = "xrgb8888", [SCENE_TEXEL_RGB565] = "rgb565",
        [SCENE_TEXEL_PALETTE] = "palette",   [SCENE_TEXEL_GRAY8] = "gray8",
        [SCENE_TEXEL_ARGB4444] = "argb4444", [SCENE_TEXEL_ARGB1555] = "argb1555",
        [SCENE_TEXEL_ARGB8888] = "argb8888", [SCENE_TEXEL_ALPHA8] = "alpha8",
    };
    int choice;
    if (!scene_choice(parser, 0, words, WORD_COUNT(words), &choice)) {
        return false;
    }
    parser->scene->texel_format = (enum scene_texel_format)choice;
    parser->texformat_line = parser->line;
    parser->texformat_statement = parser->statement;
    return true;
}

bool scene_statement_texkey(struct scene_parser *parser)
{
    if (parser->argument_count == 1) {
        static const char *const words[] = {"off"};
        int choice;
        parser->scene->texture_keyed = false;
        parser->texkey_line = 0;
        return scene_choice(parser, 0, words, WORD_COUNT(words), &choice);
    }
    parser->scene->texture_keyed = true;
    parser->texkey_line = parser->line;
    for (int i = 0; i < 3; i++) {
        int byte;
        if (!scene_integer(parser, i, 0, 255, &byte)) {
            return false;
        }
        parser->scene->texture_key[i] = (uint8_t)byte;
    }
    return true;
}

bool scene_statement_interpolate(struct scene_parser *parser)
{
    return second_word(parser, 0, "perspective", "linear", &parser->scene->screen_linear);
}

bool scene_statement_polygon(struct scene_parser *parser)
{
    static const char *const words[] = {"fill", "line", "smooth", "hidden", "wide"};
    static const struct scene_stroke thin = {
        .width = SCENE_ONE, .alpha = SCENE_ONE, .cap = SCENE_CAP_BUTT, .smooth = true};
    struct scene *scene = parser->scene;
    int choice;
    if (!scene_choice(parser, 0, words, WORD_COUNT(words), &choice)) {
        return false;
    }
    if (choice != 3 && parser->argument_count == 2) {
        return scene_fail_count(parser);
    }
    scene->wireframe = choice != 0;
    scene->smooth_lines = choice == 2;
    scene->hidden_lines = choice == 3;
    scene->wide_lines = choice == 4;
    scene->wide = choice == 2 ? thin : parser->line_state;
    scene->hidden_bias = 131; /* .002 */
    return parser->argument_count == 1 || scene_fractions(parser, 1, 1, &scene->hidden_bias);
}

bool scene_statement_antialias(struct scene_parser *parser)
{
    static const char *const words[] = {
        [SCENE_ANTIALIAS_OFF] = "off",           [SCENE_ANTIALIAS_EDGES] = "edges",
        [SCENE_ANTIALIAS_SSAA] = "ssaa",         [SCENE_ANTIALIAS_FXAA] = "fxaa",
        [SCENE_ANTIALIAS_TEMPORAL] = "temporal", [SCENE_ANTIALIAS_MSAA] = "msaa",
    };
    int choice;
    if (!scene_choice(parser, 0, words, WORD_COUNT(words), &choice)) {
        return false;
    }
    parser->scene->antialias = (enum scene_antialias)choice;
    return true;
}
