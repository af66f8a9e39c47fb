/* SPDX-License-Identifier: MIT */
/* The texture, its alpha and its mipmap levels, made when the whole scene has been read. */
#include "scene_parser.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include "mipmap.h"
#include "palette.h"
#include "picture.h"
#include "xalloc.h"

/* ---- Statements ---- */

static bool is_power_of_two(int n)
{
    return (n & (n - 1)) == 0;
}

/* W H CELLS r g b r g b */
static bool read_checkers(struct scene_parser *parser, const int32_t *value,
                          struct scene_texture_request *request)
{
    request->width = value[0];
    request->height = value[1];
    for (int i = 0; i < 2; i++) {
        if (!is_power_of_two(value[i])) {
            return scene_fail_argument(parser, i, "is not a power of two");
        }
    }
    int32_t cells;
    if (!scene_integer(parser, 2, 1, value[0] < value[1] ? value[0] : value[1], &cells)) {
        return false;
    }
    request->cells = cells;
    for (int i = 0; i < 6; i++) {
        request->rgb[i / 3][i % 3] = (uint8_t)value[3 + i];
    }
    return true;
}

/* `into` is the kind, here and below. */
bool scene_statement_texture(struct scene_parser *parser, const int32_t *value)
{
    struct scene_texture_request request = {.kind = (enum scene_source)parser->statement->into,
                                            .line = parser->line,
                                            .statement = parser->statement};
    if (request.kind == SCENE_OF_CHECKERS && !read_checkers(parser, value, &request)) {
        return false;
    }
    if (request.kind == SCENE_OF_FILE && (request.path = scene_path(parser, 0, NULL)) == NULL) {
        return false;
    }
    free(parser->texture.path);
    parser->texture = request;
    return true;
}

bool scene_statement_texalpha(struct scene_parser *parser, const int32_t *value)
{
    struct scene_alpha_request request = {.kind = (enum scene_source)parser->statement->into,
                                          .line = parser->line,
                                          .alpha = {(uint8_t)value[0], (uint8_t)value[1]}};
    if (request.kind == SCENE_OF_FILE && (request.path = scene_path(parser, 0, NULL)) == NULL) {
        return false;
    }
    free(parser->texalpha.path);
    parser->texalpha = request;
    return true;
}

/* ---- Colours ---- */

/* Which of the two colours a texel has: fields alternate in columns and rows. */
static int field_of(const struct scene_texture_request *request, int x, int y)
{
    return (y * request->cells / request->height + x * request->cells / request->width) & 1;
}

static void make_checkers(struct scene_parser *parser)
{
    const struct scene_texture_request *request = &parser->texture;
    struct scene_texture *texture = &parser->scene->texture;
    texture->rgb = xcalloc((size_t)request->width * (size_t)request->height, 3);
    texture->width = request->width;
    texture->height = request->height;
    uint8_t *texel = texture->rgb;
    for (int y = 0; y < request->height; y++) {
        for (int x = 0; x < request->width; x++, texel += 3) {
            memcpy(texel, request->rgb[field_of(request, x, y)], 3);
        }
    }
}

static bool is_texture_side(int side)
{
    return side >= 1 && side <= SCENE_MAX_TEXTURE && is_power_of_two(side);
}

static bool read_texture(struct scene_parser *parser)
{
    struct picture picture;
    struct text_error error;
    if (!picture_read_ppm(parser->texture.path, &picture, &error)) {
        return scene_fail(parser, error.message);
    }
    if (!is_texture_side(picture.width) || !is_texture_side(picture.height)) {
        text_error_set(parser->error, parser->name, parser->line,
                       "texture: %s is %d x %d; sides must be powers of two up to %d",
                       parser->texture.path, picture.width, picture.height, SCENE_MAX_TEXTURE);
        picture_free(&picture);
        return false;
    }
    parser->scene->texture.width = picture.width;
    parser->scene->texture.height = picture.height;
    parser->scene->texture.rgb = picture.rgb;
    picture.rgb = NULL;
    picture_free(&picture);
    return true;
}

static bool make_texels(struct scene_parser *parser)
{
    if (parser->texture.kind == SCENE_OF_NOTHING) {
        return true;
    }
    parser->line = parser->texture.line; /* where the message belongs */
    parser->statement = parser->texture.statement;
    if (parser->texture.kind == SCENE_OF_FILE) {
        return read_texture(parser);
    }
    make_checkers(parser);
    return true;
}

/* ---- Alpha ---- */

/* "FILE:LINE: NAME: sentence", and false. */
static bool fail(struct scene_parser *parser, int line, const char *name, const char *sentence)
{
    return text_error_set(parser->error, parser->name, line, "%s: %s", name, sentence);
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

static bool make_alpha_checkers(struct scene_parser *parser)
{
    const struct scene_texture_request *request = &parser->texture;
    uint8_t *alpha = parser->scene->texture.alpha;
    if (request->kind != SCENE_OF_CHECKERS) {
        return fail(parser, parser->texalpha.line, "texalpha",
                    "the texture is no checkerboard: give a file");
    }
    for (int y = 0; y < request->height; y++) {
        for (int x = 0; x < request->width; x++) {
            *alpha++ = parser->texalpha.alpha[field_of(request, x, y)];
        }
    }
    return true;
}

/* Nothing is ignored without a word: alpha needs a texture whose format has it. */
static bool make_alpha(struct scene_parser *parser)
{
    static const char needs[] = "needs a texture, and a texformat that has alpha";
    const struct scene *scene = parser->scene;
    struct scene_texture *texture = &parser->scene->texture;
    const struct scene_alpha_request *request = &parser->texalpha;
    if (!scene_texel_has_alpha(scene->texel_format) || texture->width == 0) {
        if (request->kind != SCENE_OF_NOTHING) {
            return fail(parser, request->line, "texalpha", needs);
        }
        return parser->alphatest_line == 0 ||
               fail(parser, parser->alphatest_line, "alphatest", needs);
    }
    if (scene->texture_keyed) {
        return fail(parser, parser->texkey_line, "texkey",
                    "the texformat has alpha: what is not drawn has an alpha of 0");
    }
    const size_t count = (size_t)texture->width * (size_t)texture->height;
    texture->alpha = xcalloc(count, 1);
    memset(texture->alpha, 255, count);
    return request->kind == SCENE_OF_NOTHING ||
           (request->kind == SCENE_OF_FILE ? read_alpha(parser) : make_alpha_checkers(parser));
}

/* ---- Levels ---- */

/* What a level's pixel is stored as: the key where it is less than half opaque, of a palette the
   nearest colour that the texture has. */
static void finish_pixel(const struct scene *scene, const struct palette *palette,
                         const uint8_t rgba[4], uint8_t rgb[3])
{
    long least = LONG_MAX;
    memcpy(rgb, scene->texture_keyed && rgba[3] < 128 ? scene->texture_key : rgba, 3);
    if (!scene_texel_has_palette(scene->texel_format) || (scene->texture_keyed && rgba[3] < 128)) {
        return;
    }
    for (int i = 0; i < palette->count; i++) {
        const uint8_t *color = palette->color[i];
        const long r = color[0] - rgba[0], g = color[1] - rgba[1], b = color[2] - rgba[2];
        const long far = r * r + g * g + b * b;
        if (far < least && !(scene->texture_keyed && memcmp(color, scene->texture_key, 3) == 0)) {
            least = far;
            memcpy(rgb, color, 3);
        }
    }
}

static void make_levels(struct scene *scene, const struct palette *palette)
{
    struct scene_texture *texture = &scene->texture;
    const size_t count = (size_t)texture->width * (size_t)texture->height;
    uint8_t *rgba = xcalloc(count, 4), *smaller = xcalloc(count, 4);
    for (size_t i = 0; i < count; i++) {
        const bool hidden =
            scene->texture_keyed && memcmp(&texture->rgb[3 * i], scene->texture_key, 3) == 0;
        memcpy(&rgba[4 * i], &texture->rgb[3 * i], 3);
        rgba[4 * i + 3] = hidden ? 0 : texture->alpha != NULL ? texture->alpha[i] : 255;
    }
    for (int level = 1; level <= mipmap_count(texture->width); level++) {
        const size_t pixels = (size_t)mipmap_side(texture->width, level) *
                              (size_t)mipmap_side(texture->height, level);
        uint8_t *rgb = xcalloc(pixels, 3);
        uint8_t *alpha = xcalloc(pixels, 1);
        texture->level_alpha[texture->level_count] = alpha;
        texture->level[texture->level_count++] = rgb;
        mipmap_level(rgba, texture->width, texture->height, level, smaller);
        for (size_t i = 0; i < pixels; i++) {
            finish_pixel(scene, palette, &smaller[4 * i], &rgb[3 * i]);
            alpha[i] = smaller[4 * i + 3];
        }
    }
    free(rgba);
    free(smaller);
}

bool scene_make_texture(struct scene_parser *parser)
{
    struct scene *scene = parser->scene;
    struct palette palette = {.count = 0};
    if (!make_texels(parser) || !make_alpha(parser)) {
        return false;
    }
    if (scene_texel_has_palette(scene->texel_format)) {
        size_t count = (size_t)scene->texture.width * (size_t)scene->texture.height;
        if (!palette_make(&palette, scene->texture.rgb, count, NULL)) {
            return text_error_set(parser->error, parser->name, parser->texformat_line,
                                  "texformat: the texture of line %d has more than %d colours",
                                  parser->texture.line, PALETTE_MAX);
        }
    }
    if (scene->texture_mipmapped && scene->texture.width > 0) {
        make_levels(scene, &palette);
    }
    return true;
}
