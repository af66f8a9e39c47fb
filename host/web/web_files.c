/* SPDX-License-Identifier: MIT */
#define _XOPEN_SOURCE 700
#include "web_files.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "../io/file.h"
#include "../io/file_identity.h"

struct web_file {
    char *name, *bytes;
    size_t length;
};

enum { MOST_FILES = 1024 };

static struct web_file files[MOST_FILES];
static size_t file_count;

static const char *base_name(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash != NULL ? slash + 1 : path;
}

static struct web_file *find_as(const char *name, const char *(*part)(const char *))
{
    for (size_t i = 0; i < file_count; i++) {
        if (strcmp(part(files[i].name), part(name)) == 0) {
            return &files[i];
        }
    }
    return NULL;
}

static const char *whole_name(const char *path)
{
    return path;
}

/* A browser hands over files without their folders: textures/skin.png is skin.png here. */
static struct web_file *find(const char *name)
{
    struct web_file *file = find_as(name, whole_name);
    return file != NULL ? file : find_as(name, base_name);
}

/* Takes the memory of `bytes`. */
static bool store(const char *name, char *bytes, size_t length)
{
    struct web_file *file = find_as(name, whole_name);
    char *copy = file == NULL && file_count < MOST_FILES ? strdup(name) : NULL;
    if (file == NULL && copy != NULL) {
        file = &files[file_count++];
        *file = (struct web_file){.name = copy};
    }
    if (file == NULL) {
        free(bytes);
        return false;
    }
    free(file->bytes);
    file->bytes = bytes;
    file->length = length;
    return true;
}

char *web_file_create(const char *name, size_t length)
{
    char *bytes = malloc(length + 1);
    return bytes != NULL && store(name, bytes, length) ? bytes : NULL;
}

char *web_file_content(const char *name)
{
    const struct web_file *file = find(name);
    return file != NULL ? file->bytes : NULL;
}

size_t web_file_length(const char *name)
{
    const struct web_file *file = find(name);
    return file != NULL ? file->length : 0;
}

void web_files_clear(void)
{
    while (file_count > 0) {
        file_count--;
        free(files[file_count].name);
        free(files[file_count].bytes);
    }
}

/* ---- file_identity.h ---- */

enum file_kind file_inspect(const char *path, struct file_identity *identity)
{
    const struct web_file *file = find(path);
    if (file != NULL && identity != NULL) {
        *identity = (struct file_identity){0, (uint64_t)(file - files)};
    }
    return file != NULL ? FILE_REGULAR : FILE_MISSING;
}

/* ---- file.h ---- */

bool file_read(const char *path, struct file_content *content, struct text_error *error)
{
    const struct web_file *file = find(path);
    *content = (struct file_content){.bytes = NULL};
    if (file == NULL) {
        return text_error_set(error, path, 0, "is not among the files of the page");
    }
    content->bytes = malloc(file->length + 1);
    if (content->bytes == NULL) {
        return text_error_set(error, path, 0, "out of memory");
    }
    memcpy(content->bytes, file->bytes, file->length);
    content->length = file->length;
    return true;
}

bool file_is_stream(const char *path)
{
    return strcmp(path, "-") == 0;
}

static void release(struct file_output *output)
{
    free(output->path);
    memset(output, 0, sizeof *output);
}

/* What is written grows in `temporary`, until its stream is closed. */
bool file_output_open(struct file_output *output, const char *path, struct text_error *error)
{
    static size_t length; /* ftell() says it, too */
    memset(output, 0, sizeof *output);
    output->path = strdup(path);
    output->stream = output->path != NULL ? open_memstream(&output->temporary, &length) : NULL;
    const bool ok = output->stream != NULL;
    if (!ok) {
        text_error_set(error, path, 0, "out of memory");
        release(output);
    }
    return ok;
}

void file_output_write(struct file_output *output, const void *bytes, size_t length)
{
    if (output->failure == 0 && fwrite(bytes, 1, length, output->stream) != length) {
        output->failure = ENOMEM;
    }
}

bool file_output_commit(struct file_output *output, struct text_error *error)
{
    const long length = fflush(output->stream) == 0 ? ftell(output->stream) : -1;
    bool ok = fclose(output->stream) == 0 && output->failure == 0 && length >= 0;
    if (ok) {
        ok = store(output->path, output->temporary, (size_t)length);
    } else {
        free(output->temporary);
    }
    if (!ok) {
        text_error_set(error, output->path, 0, "out of memory");
    }
    release(output);
    return ok;
}

void file_output_cancel(struct file_output *output)
{
    if (output->stream != NULL) {
        (void)fclose(output->stream);
    }
    free(output->temporary);
    release(output);
}
