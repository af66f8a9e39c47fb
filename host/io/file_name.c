/* SPDX-License-Identifier: MIT */
/* Names of files, of which none is looked at. */
#include "file.h"

#include <stdio.h>
#include <string.h>

bool file_name_ends_in(const char *name, const char *end)
{
    size_t length = strlen(name), tail = strlen(end);
    return length > tail && strcmp(name + length - tail, end) == 0;
}

bool file_path_beside(char *out, size_t size, const char *beside, const char *name)
{
    const char *slash = strrchr(beside, '/');
    int folder = slash == NULL || name[0] == '/' ? 0 : (int)(slash - beside) + 1;
    int length = snprintf(out, size, "%.*s%s", folder, beside, name);
    return length >= 0 && (size_t)length < size;
}
