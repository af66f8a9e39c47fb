/* SPDX-License-Identifier: MIT */
/*
 * What the tests of host/io share: files of their own, and errors compared as a whole.
 */
#ifndef QTRI_TESTS_IO_CHECK_H
#define QTRI_TESTS_IO_CHECK_H

#include <stdint.h>

#include "test.h"

#include <dirent.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define ONE 65536 /* 1.0 as Q16.16 */

#define ARRAY_LENGTH(array) (sizeof(array) / sizeof((array)[0]))

#define PATH_SIZE 600

/* A folder for this program's files, made by io_setup and removed, files included, by io_teardown.
 */
static char io_folder[PATH_SIZE / 2];

static inline int io_setup(void **state)
{
    (void)state;
    const char *base = getenv("QTRI_TMP");
    int length = snprintf(io_folder, sizeof io_folder, "%s/qtri-io-XXXXXX",
                          base != NULL && base[0] != '\0' ? base : "/tmp");
    return length < (int)sizeof io_folder && mkdtemp(io_folder) != NULL ? 0 : -1;
}

/* PATH_SIZE characters, valid until the fourth call from here. */
static inline const char *io_path(const char *name)
{
    static char paths[4][PATH_SIZE];
    static int next;
    next = (next + 1) % 4;
    (void)snprintf(paths[next], PATH_SIZE, "%s/%s", io_folder, name);
    return paths[next];
}

static inline int io_count_files(void)
{
    int count = 0;
    DIR *folder = opendir(io_folder);
    assert_non_null(folder);
    for (struct dirent *entry = readdir(folder); entry != NULL; entry = readdir(folder)) {
        count += strcmp(entry->d_name, ".") != 0 && strcmp(entry->d_name, "..") != 0;
    }
    (void)closedir(folder);
    return count;
}

static inline int io_remove_files(void **state)
{
    (void)state;
    DIR *folder = opendir(io_folder);
    if (folder == NULL) {
        return -1;
    }
    for (struct dirent *entry = readdir(folder); entry != NULL; entry = readdir(folder)) {
        (void)remove(io_path(entry->d_name)); /* fails for . and .. */
    }
    return closedir(folder);
}

static inline int io_teardown(void **state)
{
    return io_remove_files(state) == 0 ? rmdir(io_folder) : -1;
}

static inline const char *io_write(const char *name, const void *bytes, size_t length)
{
    const char *path = io_path(name);
    FILE *file = fopen(path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(bytes, 1, length, file), length);
    assert_int_equal(fclose(file), 0);
    return path;
}

static inline const char *io_write_text(const char *name, const char *text)
{
    return io_write(name, text, strlen(text));
}

/* A heap copy without a terminating NUL: a sanitizer sees every step beyond the end. */
static inline char *exact_copy(const char *text, size_t length)
{
    char *copy = malloc(length > 0 ? length : 1);
    assert_non_null(copy);
    memcpy(copy, text, length);
    return copy;
}

/* The path of a model, or NULL after saying that the test is skipped. */
static inline const char *model_path(const char *name)
{
    static char path[PATH_SIZE];
    const char *models = getenv("QTRI_MODELS");
    if (models != NULL && models[0] != '\0') {
        (void)snprintf(path, sizeof path, "%s/%s", models, name);
        if (access(path, R_OK) == 0) {
            return path;
        }
    }
    print_message(
        "skipped: no %s in the folder of MODELS: host/bench/README.md, Models, has where to "
        "get it\n",
        name);
    return NULL;
}

#endif
