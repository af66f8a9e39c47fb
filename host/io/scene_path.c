/* SPDX-License-Identifier: MIT */
/* Files that a scene names: where they are, and whether it may read them. */
#define _XOPEN_SOURCE 700
#include "scene_parser.h"

#include <stdlib.h>
#include <string.h>

#include "system.h"
#include "xalloc.h"

/* An absolute path as it is, another one in the folder of the scene file. NULL with the error. */
static char *join_path(struct scene_parser *parser, int argument)
{
    const struct token *token = &parser->arguments[argument];
    if (token_is_binary(token)) {
        scene_fail_argument(parser, argument, "is not a file name");
        return NULL;
    }
    const char *slash = token->text[0] == '/' ? NULL : strrchr(parser->name, '/');
    size_t folder = slash == NULL ? 0 : (size_t)(slash - parser->name) + 1;
    char *path = xcalloc(folder + token->length + 1, 1);
    memcpy(path, parser->name, folder);
    memcpy(path + folder, token->text, token->length);
    return path;
}

/* Whether the scene may read it, see scene_read_below(). */
static bool is_allowed(struct scene_parser *parser, const char *path,
                       const struct file_identity *identity)
{
    struct file_identity output;
    if (parser->output != NULL && file_inspect(parser->output, &output) == FILE_REGULAR &&
        file_is_same(&output, identity)) {
        return text_error_set(parser->error, parser->name, parser->line,
                              "%s: %s would be overwritten", parser->statement->name, path);
    }
    if (parser->root == NULL) {
        return true;
    }
    const size_t length = strlen(parser->root);
    char *real = system_real_path(path);
    const bool below = real != NULL && strncmp(real, parser->root, length) == 0 &&
                       (real[length] == '/' || length == 1);
    free(real);
    if (!below) {
        text_error_set(parser->error, parser->name, parser->line,
                       "%s: %s is not below the scene's folder (--allow-files)",
                       parser->statement->name, path);
    }
    return below;
}

/* Devices and pipes are refused: a scene from elsewhere should not be able to make us wait. */
static bool inspect(struct scene_parser *parser, const char *path, struct file_identity *identity)
{
    switch (file_inspect(path, identity)) {
    case FILE_REGULAR:
        return is_allowed(parser, path, identity);
    case FILE_MISSING:
        return text_error_set(parser->error, parser->name, parser->line, "%s: %s does not exist",
                              parser->statement->name, path);
    case FILE_OTHER:
        break;
    }
    return text_error_set(parser->error, parser->name, parser->line,
                          "%s: %s is not an ordinary file", parser->statement->name, path);
}

char *scene_path(struct scene_parser *parser, int argument, struct file_identity *identity)
{
    struct file_identity own = {0};
    char *path = join_path(parser, argument);
    if (path != NULL && !inspect(parser, path, identity != NULL ? identity : &own)) {
        free(path);
        return NULL;
    }
    return path;
}
