/* SPDX-License-Identifier: MIT */
/* Statements about the alpha of texels. */
#include <stdlib.h>
#include <string.h>

#include "picture.h"
#include "scene_parser.h"

static bool byte(struct scene_parser *parser, int argument, uint8_t *value)
{
    int number;
    const bool ok = scene_integer(parser, argument, 0, 255, &number);
    *value = ok ? (uint8_t)number : 0;
    return ok;
}

bool scene_statement_texalpha(struct scene_parser *parser)
{
    struct scene_alpha_request request = {.kind = SCENE_ALPHA_OFF, .line = parser->line};
    if (parser->argument_count == 2) {
        request.kind = SCENE_ALPHA_CHECKERS;
        if (!byte(parser, 0, &request.alpha[0]) || !byte(parser, 1, &request.alpha[1])) {
            return false;
        }
    } else if (!token_equals(&parser->arguments[0], "off")) {
        request.kind = SCENE_ALPHA_FILE;
        request.path = scene_path(parser, 0);
        if (request.path == NULL || !scene_inspect(parser, request.path, NULL)) {
            free(request.path);
            return false;
        }
    }
    free(parser->texalpha.path);
    parser->texalpha = request;
    return true;
}

bool scene_statement_alphatest(struct scene_parser *parser)
{
    parser->scene->least_alpha = 0;
    parser->alphatest_line = 0;
    if (token_equals(&parser->arguments[0], "off")) {
        return true;
    }
    parser->alphatest_line = parser->line;
    return scene_integer(parser, 0, 0, 255, &parser->scene->least_alpha);
}

/* "FILE:LINE: NAME: sentence", and false. */
static bool fail(struct scene_parser *parser, int line, const char *name, const char *sentence)
{
    text_error_set(parser->error, parser->name, line, "%s: %s", name, sentence);
    return false;
}

/* Luma, as gray texels have it. */
static bool read_alpha(struct scene_parser *parser)
{
    struct scene_texture *texture = &parser->scene->texture;
    struct picture picture;
    struct text_error error;
    const int line = parser->texalpha.line;
    if (!picture_read_ppm(parser->texalpha.path, &picture, &error)) {
        return fail(parser, line, "texalpha", error.message);
    }
    const bool fits = picture.width == texture->width && picture.height == texture->height;
    if (!fits) {
        text_error_set(parser->error, parser->name, line,
                       "texalpha: %s is %d x %d, the texture %d x %d", parser->texalpha.path,
                       picture.width, picture.height, texture->width, texture->height);
    }
    const uint8_t *rgb = picture.rgb;
    for (size_t i = 0; fits && i < (size_t)texture->width * (size_t)texture->height;
         i++, rgb += 3) {
        texture->alpha[i] = (uint8_t)((299u * rgb[0] + 587u * rgb[1] + 114u * rgb[2] + 500) / 1000);
    }
    picture_free(&picture);
    return fits;
}

static void make_checkers(struct scene_parser *parser)
{
    const struct scene_texture_request *request = &parser->texture;
    uint8_t *alpha = parser->scene->texture.alpha;
    for (int y = 0; y < request->height; y++) {
        const int row = y * request->cells / request->height;
        for (int x = 0; x < request->width; x++) {
            const int column = x * request->cells / request->width;
            *alpha++ = parser->texalpha.alpha[(row + column) & 1];
        }
    }
}

static bool make_alpha(struct scene_parser *parser)
{
    struct scene_texture *texture = &parser->scene->texture;
    const size_t count = (size_t)texture->width * (size_t)texture->height;
    texture->alpha = malloc(count);
    if (texture->alpha == NULL) {
        return fail(parser, parser->texformat_line, "texformat", "out of memory");
    }
    memset(texture->alpha, 255, count);
    switch (parser->texalpha.kind) {
    case SCENE_ALPHA_CHECKERS:
        if (parser->texture.kind != SCENE_TEXTURE_CHECKERS) {
            return fail(parser, parser->texalpha.line, "texalpha",
                        "the texture is no checkerboard: give a file");
        }
        make_checkers(parser);
        return true;
    case SCENE_ALPHA_FILE:
        return read_alpha(parser);
    case SCENE_ALPHA_OFF:
        break;
    }
    return true;
}

/* Nothing is ignored without a word: alpha needs a texture whose format has it. */
bool scene_make_alpha(struct scene_parser *parser)
{
    const struct scene *scene = parser->scene;
    const bool has_alpha = scene_texel_has_alpha(scene->texel_format) && scene->texture.width > 0;
    if (!has_alpha && parser->texalpha.kind != SCENE_ALPHA_OFF) {
        return fail(parser, parser->texalpha.line, "texalpha",
                    "needs a texture, and a texformat that has alpha");
    }
    if (!has_alpha && parser->alphatest_line != 0) {
        return fail(parser, parser->alphatest_line, "alphatest",
                    "needs a texture, and a texformat that has alpha");
    }
    if (has_alpha && scene->texture_keyed) {
        return fail(parser, parser->texkey_line, "texkey",
                    "the texformat has alpha: what is not drawn has an alpha of 0");
    }
    return !has_alpha || make_alpha(parser);
}
