/* SPDX-License-Identifier: MIT */
/*
 * What is behind a path, and whether two paths lead to the same file.
 */
#ifndef QTRI_HOST_IO_FILE_IDENTITY_H
#define QTRI_HOST_IO_FILE_IDENTITY_H

#include <stdbool.h>
#include <stdint.h>

enum file_kind { FILE_MISSING, FILE_REGULAR, FILE_OTHER /* folder, device, pipe, unreachable */ };

struct file_identity {
    uint64_t device;
    uint64_t number;
};

/* `identity` may be NULL; it is written for files that exist. */
enum file_kind file_inspect(const char *path, struct file_identity *identity);

/* The same of an open descriptor. */
enum file_kind file_inspect_open(int descriptor, struct file_identity *identity);

static inline bool file_is_same(const struct file_identity *a, const struct file_identity *b)
{
    return a->device == b->device && a->number == b->number;
}

#endif
