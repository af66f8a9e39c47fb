/* SPDX-License-Identifier: MIT */
#define _POSIX_C_SOURCE 200809L
#include "asset.h"

#include <stdlib.h>
#include <string.h>

static bool open_source(struct asset_files *files, const char *path, struct text_error *error)
{
    char *source = strdup(path);
    if (source == NULL) {
        return text_error_set(error, path, 0, "out of memory");
    }
    source[strlen(source) - 1] = 'c'; /* of NAME.h */
    bool ok = file_output_open(&files->source, source, error);
    free(source);
    return ok;
}

bool asset_files_open(struct asset_files *files, const char *path, bool split,
                      struct text_error *error)
{
    const char *slash = strrchr(path, '/');
    memset(files, 0, sizeof *files);
    files->header_name = slash != NULL ? slash + 1 : path;
    if (!file_output_open(&files->header, path, error)) {
        return false;
    }
    if (split && !open_source(files, path, error)) {
        file_output_cancel(&files->header);
        return false;
    }
    return true;
}

bool asset_files_commit(struct asset_files *files, struct text_error *error)
{
    if (files->source.stream != NULL && !file_output_commit(&files->source, error)) {
        file_output_cancel(&files->header);
        return false;
    }
    return file_output_commit(&files->header, error);
}
