/* SPDX-License-Identifier: MIT */
#include "file_inputs.h"

#include <stddef.h>

#include "array.h"
#include "file_identity.h"

/* Files, and whether the program made them itself. */
struct known {
    struct file_identity identity;
    bool is_own;
};

static struct known *files;
static size_t file_count, file_room;
static bool is_guarded;

void file_inputs_guard(void)
{
    is_guarded = true;
}

static const struct known *find(const struct file_identity *identity)
{
    for (size_t i = 0; i < file_count; i++) {
        if (file_is_same(&files[i].identity, identity)) {
            return &files[i];
        }
    }
    return NULL;
}

static void add(int descriptor, bool is_own)
{
    struct known file = {{0, 0}, is_own};
    if (!is_guarded || file_inspect_open(descriptor, &file.identity) != FILE_REGULAR ||
        find(&file.identity) != NULL) {
        return;
    }
    files = array_grow(files, file_count, &file_room, sizeof *files);
    files[file_count++] = file;
}

void file_inputs_add(int descriptor)
{
    add(descriptor, false);
}

void file_inputs_except(int descriptor)
{
    add(descriptor, true);
}

bool file_inputs_has(const char *path)
{
    struct file_identity identity;
    if (file_count == 0 || file_inspect(path, &identity) != FILE_REGULAR) {
        return false;
    }
    const struct known *file = find(&identity);
    return file != NULL && !file->is_own;
}
