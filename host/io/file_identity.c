/* SPDX-License-Identifier: MIT */
#define _XOPEN_SOURCE 700
#include "file_identity.h"

#ifndef _WIN32

#include <errno.h>
#include <stddef.h>
#include <sys/stat.h>

static enum file_kind kind_of(const struct stat *status, struct file_identity *identity)
{
    if (identity != NULL) {
        identity->device = (uint64_t)status->st_dev;
        identity->number = (uint64_t)status->st_ino;
    }
    return S_ISREG(status->st_mode) ? FILE_REGULAR : FILE_OTHER;
}

enum file_kind file_inspect(const char *path, struct file_identity *identity)
{
    struct stat status;
    if (stat(path, &status) != 0) {
        return errno == ENOENT || errno == ENOTDIR ? FILE_MISSING : FILE_OTHER;
    }
    return kind_of(&status, identity);
}

enum file_kind file_inspect_open(int descriptor, struct file_identity *identity)
{
    struct stat status;
    return fstat(descriptor, &status) == 0 ? kind_of(&status, identity) : FILE_OTHER;
}

#endif
