/* SPDX-License-Identifier: MIT */
#include "scene_parser.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include "array.h"
#include "mipmap.h"
#include "palette.h"
#include "picture.h"

/* ---- Meshes ---- */

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

static bool grow_meshes(struct scene_parser *parser)
{
    size_t count = parser->scene->mesh_count;
    struct obj_mesh *meshes =
        array_grow(parser->scene->meshes, count, &parser->mesh_capacity, sizeof *meshes);
    if (meshes != NULL) {
        parser->scene->meshes = meshes;
    }
    struct scene_mesh_file *files =
        array_grow(parser->mesh_files, count, &parser->mesh_file_capacity, sizeof *files);
    if (files != NULL) {
        parser->mesh_files = files;
    }
    return (meshes != NULL && files != NULL) || scene_fail(parser, "out of memory");
}

static bool find_or_read_mesh(struct scene_parser *parser, const char *path,
                              const struct obj_scale *scale, size_t *mesh)
{
    struct scene_mesh_file file = {.scale = {0}};
    if (scale != NULL) {
        file.scale = *scale;
    }
    const bool is_scaled = file.scale.factor > 0.0 || file.scale.fit > 0.0;
    if (!scene_inspect(parser, path, &file.identity)) {
        return false;
    }
    if (known_mesh(parser, &file, mesh)) {
        return true;
    }
    struct text_error error;
    if (!grow_meshes(parser)) {
        return false;
    }
    *mesh = parser->scene->mesh_count;
    if (!obj_read_scaled(path, is_scaled ? &file.scale : NULL, &parser->scene->meshes[*mesh],
                         &error)) {
        return scene_fail(parser, error.message);
    }
    parser->mesh_files[*mesh] = file;
    parser->scene->mesh_count++;
    return true;
}

bool scene_find_mesh(struct scene_parser *parser, int argument, const struct obj_scale *scale,
                     size_t *mesh)
{
    char *path = scene_path(parser, argument);
    bool found = path != NULL && find_or_read_mesh(parser, path, scale, mesh);
    free(path);
    return found;
}

/* ---- Textures ---- */

static bool is_texture_side(int side)
{
    return side >= 1 && side <= SCENE_MAX_TEXTURE && (side & (side - 1)) == 0;
}

static bool request_checkers(struct scene_parser *parser, struct scene_texture_request *request)
{
    int *sides[] = {&request->width, &request->height};
    for (int i = 0; i < 2; i++) {
        if (!scene_integer(parser, i, 1, SCENE_MAX_TEXTURE, sides[i])) {
            return false;
        }
        if (!is_texture_side(*sides[i])) {
            return scene_fail_argument(parser, i, "is not a power of two");
        }
    }
    int smaller = request->width < request->height ? request->width : request->height;
    if (!scene_integer(parser, 2, 1, smaller, &request->cells)) {
        return false;
    }
    for (int i = 0; i < 6; i++) {
        int byte;
        if (!scene_integer(parser, 3 + i, 0, 255, &byte)) {
            return false;
        }
        request->rgb[i / 3][i % 3] = (uint8_t)byte;
    }
    request->kind = SCENE_TEXTURE_CHECKERS;
    return true;
}

static bool request_file(struct scene_parser *parser, struct scene_texture_request *request)
{
    request->path = scene_path(parser, 0);
    if (request->path == NULL) {
        return false;
    }
    if (!scene_inspect(parser, request->path, NULL)) {
        free(request->path);
        return false;
    }
    request->kind = SCENE_TEXTURE_FILE;
    return true;
}

bool scene_statement_texture(struct scene_parser *parser)
{
    struct scene_texture_request request = {.kind = SCENE_TEXTURE_OFF, .line = parser->line};
    if (parser->argument_count == 9) {
        if (!request_checkers(parser, &request)) {
            return false;
        }
    } else if (!token_equals(&parser->arguments[0], "off") && !request_file(parser, &request)) {
        return false;
    }
    request.statement = parser->statement;
    free(parser->texture.path);
    parser->texture = request;
    return true;
}

/* CELLS x CELLS fields; the parity of a field's column + row chooses its colour. */
static bool make_checkers(struct scene_parser *parser)
{
    const struct scene_texture_request *request = &parser->texture;
    struct scene_texture *texture = &parser->scene->texture;
    texture->rgb = malloc((size_t)request->width * (size_t)request->height * 3);
    if (texture->rgb == NULL) {
        return scene_fail(parser, "out of memory");
    }
    texture->width = request->width;
    texture->height = request->height;
    uint8_t *texel = texture->rgb;
    for (int y = 0; y < request->height; y++) {
        int row = y * request->cells / request->height;
        for (int x = 0; x < request->width; x++, texel += 3) {
            int column = x * request->cells / request->width;
            memcpy(texel, request->rgb[(row + column) & 1], 3);
        }
    }
    return true;
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
    parser->line = parser->texture.line; /* where the message belongs */
    parser->statement = parser->texture.statement;
    switch (parser->texture.kind) {
    case SCENE_TEXTURE_CHECKERS:
        return make_checkers(parser);
    case SCENE_TEXTURE_FILE:
        return read_texture(parser);
    case SCENE_TEXTURE_OFF:
        break;
    }
    return true;
}

/* What a level's pixel is stored as: the key where it is less than half opaque, of a palette the
   nearest colour that the texture has. */
static void finish_pixel(const struct scene *scene, const struct palette *palette,
                         const uint8_t rgba[4], uint8_t rgb[3])
{
    long least = LONG_MAX;
    memcpy(rgb, scene->texture_keyed && rgba[3] < 128 ? scene->texture_key : rgba, 3);
    if (scene->texel_format != SCENE_TEXEL_PALETTE || (scene->texture_keyed && rgba[3] < 128)) {
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

static bool make_levels(struct scene *scene, const struct palette *palette)
{
    struct scene_texture *texture = &scene->texture;
    const size_t count = (size_t)texture->width * (size_t)texture->height;
    uint8_t *rgba = malloc(4 * count), *smaller = malloc(4 * count);
    bool ok = rgba != NULL && smaller != NULL;
    for (size_t i = 0; ok && i < count; i++) {
        const bool hidden =
            scene->texture_keyed && memcmp(&texture->rgb[3 * i], scene->texture_key, 3) == 0;
        memcpy(&rgba[4 * i], &texture->rgb[3 * i], 3);
        rgba[4 * i + 3] = hidden ? 0 : texture->alpha != NULL ? texture->alpha[i] : 255;
    }
    for (int level = 1; ok && level <= mipmap_count(texture->width); level++) {
        const size_t pixels = (size_t)mipmap_side(texture->width, level) *
                              (size_t)mipmap_side(texture->height, level);
        uint8_t *rgb = malloc(3 * pixels);
        uint8_t *alpha = malloc(pixels);
        ok = rgb != NULL && alpha != NULL;
        if (!ok) {
            free(rgb);
            free(alpha);
        } else {
            texture->level_alpha[texture->level_count] = alpha;
            texture->level[texture->level_count++] = rgb;
            mipmap_level(rgba, texture->width, texture->height, level, smaller);
        }
        for (size_t i = 0; ok && i < pixels; i++) {
            finish_pixel(scene, palette, &smaller[4 * i], &rgb[3 * i]);
            alpha[i] = smaller[4 * i + 3];
        }
    }
    free(rgba);
    free(smaller);
    return ok;
}

bool scene_make_texture(struct scene_parser *parser)
{
    struct scene *scene = parser->scene;
    struct palette palette = {.count = 0};
    if (!make_texels(parser) || !scene_make_alpha(parser)) {
        return false;
    }
    if (scene->texel_format == SCENE_TEXEL_PALETTE) {
        size_t count = (size_t)scene->texture.width * (size_t)scene->texture.height;
        if (!palette_make(&palette, scene->texture.rgb, count, NULL)) {
            text_error_set(parser->error, parser->name, parser->texformat_line,
                           "%s: the texture of line %d has more than %d colours",
                           parser->texformat_statement->name, parser->texture.line, PALETTE_MAX);
            return false;
        }
    }
    if (scene->texture_mipmapped && scene->texture.width > 0 && !make_levels(scene, &palette)) {
        return scene_fail(parser, "out of memory");
    }
    return true;
}
