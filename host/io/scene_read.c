/* SPDX-License-Identifier: MIT */
/* Reads the text of a scene. */
#include "scene.h"

#include <stdlib.h>
#include <string.h>

#include "scene_parser.h"
#include "xalloc.h"
#include "system.h"

/* ---- Lines ---- */

/* Keeps the arguments there is room for and counts them all. */
static void take_arguments(struct scene_parser *parser, struct line *line)
{
    struct token token;
    parser->argument_count = 0;
    while (line_token(line, &token)) {
        if (parser->argument_count < SCENE_MAX_ARGUMENTS) {
            parser->arguments[parser->argument_count] = token;
        }
        parser->argument_count++;
    }
}

static bool parse_line(struct scene_parser *parser, struct line *line)
{
    struct token keyword;
    parser->line = line->number;
    parser->line_text = line->at;
    if (!line_token(line, &keyword)) {
        return true;
    }
    take_arguments(parser, line);
    const bool ok = scene_parse_statement(parser, &keyword);
    parser->any_statement = true;
    return ok;
}

/* ---- Scenes ---- */

static void set_defaults(struct scene *scene)
{
    memset(scene, 0, sizeof *scene);
    scene->width = 256;
    scene->height = 256;
    scene->clear_depth = SCENE_ONE;
    scene->depth_write = true;
    scene->alpha = 65536;
    scene->depth_compare = SCENE_LESS;
    scene->cull = SCENE_CULL_NONE;
    scene->provoking = 2;
    scene->texture_mode = SCENE_MODULATE;
    scene->depth_far = SCENE_ONE;
}

/* All that a pass begins with. */
static void begin_pass(struct scene_parser *parser, struct scene *scene)
{
    set_defaults(scene);
    parser->scene = scene;
    parser->mode = 1;
    parser->stroke.width = SCENE_ONE;
    parser->stroke.alpha = SCENE_ONE;
    parser->stroke.smooth = true;
    parser->point_size = 4 * SCENE_ONE;
    scene_brush_defaults(&parser->brush);
}

static void free_requests(struct scene_parser *parser)
{
    free(parser->mesh_files);
    free(parser->texture.path);
    free(parser->texalpha.path);
    scene_brush_free(&parser->brush);
}

/* Of the whole picture there is one. */
static void copy_picture(const struct scene *from, struct scene *to)
{
    to->width = from->width;
    to->height = from->height;
    memcpy(to->clear, from->clear, sizeof to->clear);
    to->clear_depth = from->clear_depth;
    to->depth_format = from->depth_format;
    to->antialias = from->antialias;
}

/* A few statements name many textures: those of all passes together have a bound. */
static bool finish_pass(struct scene_parser *parser)
{
    enum { MOST_TEXELS = 16 * 1024 * 1024 };
    const struct scene_texture *texture = &parser->scene->texture;
    parser->first->triangle_count = parser->scene->triangle_count;
    copy_picture(parser->first, parser->scene);
    if (!scene_make_texture(parser)) {
        return false;
    }
    parser->texel_count += (size_t)texture->width * (size_t)texture->height;
    return parser->texel_count <= MOST_TEXELS ||
           scene_fail(parser, "the textures of all passes have more than 16777216 texels");
}

bool scene_statement_pass(struct scene_parser *parser, const int32_t *value)
{
    enum { MOST = 1024 };
    struct scene_parser fresh = {.name = parser->name,
                                 .error = parser->error,
                                 .first = parser->first,
                                 .pass_count = parser->pass_count + 1,
                                 .root = parser->root,
                                 .output = parser->output,
                                 .time = parser->time,
                                 .line = parser->line,
                                 .any_statement = true};
    (void)value;
    if (!finish_pass(parser)) {
        return false;
    }
    fresh.texel_count = parser->texel_count;
    if (fresh.pass_count >= MOST) {
        return scene_fail(parser, "there are too many");
    }
    struct scene *next = xcalloc(1, sizeof *next);
    begin_pass(&fresh, next);
    copy_picture(parser->first, next);
    next->triangle_count = parser->scene->triangle_count;
    next->triangles_before = next->triangle_count;
    parser->scene->next = next;
    free_requests(parser);
    *parser = fresh;
    return true;
}

static bool parse_all(struct scene_parser *parser, const char *text, size_t length)
{
    struct line_reader reader;
    struct line line;
    lines_begin(&reader, text, length, false);
    while (lines_next(&reader, &line)) {
        if (!parse_line(parser, &line)) {
            return false;
        }
    }
    return finish_pass(parser);
}

/* Takes `root`, which it frees. */
static bool parse(const char *name, const char *text, size_t length, char *root,
                  const struct scene_reading *how, struct scene *scene, struct text_error *error)
{
    struct scene_parser parser = {
        .name = name, .error = error, .first = scene, .output = how->output, .time = how->time};
    parser.root = root;
    begin_pass(&parser, scene);
    bool ok = parse_all(&parser, text, length);
    free_requests(&parser);
    free(parser.root);
    if (!ok) {
        scene_free(scene);
    }
    return ok;
}

bool scene_parse(const char *name, const char *text, size_t length, struct scene *scene,
                 struct text_error *error)
{
    const struct scene_reading how = {.output = NULL};
    return parse(name, text, length, NULL, &how, scene, error);
}

/* The folder of `path` without links; NULL when it is gone. */
static char *folder_of(const char *path)
{
    const char *slash = strrchr(path, '/');
    const size_t length = slash == NULL ? 0 : (size_t)(slash - path) + 1;
    char *folder = xcalloc(length + 2, 1);
    memcpy(folder, path, length);
    memcpy(folder + length, ".", 2);
    char *real = system_real_path(folder);
    free(folder);
    return real;
}

static bool is_same_file(const char *a, const char *b)
{
    struct file_identity one;
    struct file_identity other;
    return file_inspect(a, &one) == FILE_REGULAR && file_inspect(b, &other) == FILE_REGULAR &&
           file_is_same(&one, &other);
}

bool scene_read_as(const char *path, const struct scene_reading *how, struct scene *scene,
                   struct text_error *error)
{
    struct file_content file;
    memset(scene, 0, sizeof *scene);
    if (how->output != NULL && is_same_file(path, how->output)) {
        return text_error_set(error, path, 0, "would be overwritten by %s", how->output);
    }
    char *root = how->below ? folder_of(path) : NULL;
    if (how->below && root == NULL) {
        return text_error_set(error, path, 0, "has no folder");
    }
    if (!file_read(path, &file, error)) {
        free(root);
        return false;
    }
    bool ok = parse(path, file.bytes, file.length, root, how, scene, error);
    free(file.bytes);
    return ok;
}

bool scene_read(const char *path, struct scene *scene, struct text_error *error)
{
    const struct scene_reading how = {.output = NULL};
    return scene_read_as(path, &how, scene, error);
}

static void free_pass(struct scene *scene)
{
    for (size_t i = 0; i < scene->mesh_count; i++) {
        obj_free(&scene->meshes[i]);
    }
    free(scene->meshes);
    free(scene->ops);
    free(scene->stroke_vertices);
    free(scene->keys);
    free(scene->models);
    free(scene->texture.rgb);
    free(scene->texture.alpha);
    for (int i = 0; i < scene->texture.level_count; i++) {
        free(scene->texture.level[i]);
        free(scene->texture.level_alpha[i]);
    }
    scene_paints_free(&scene->paints);
}

void scene_free(struct scene *scene)
{
    for (struct scene *next = scene->next; next != NULL;) {
        struct scene *after = next->next;
        free_pass(next);
        free(next);
        next = after;
    }
    free_pass(scene);
    memset(scene, 0, sizeof *scene);
}
