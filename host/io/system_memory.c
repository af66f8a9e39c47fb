/* SPDX-License-Identifier: MIT */
/* Of system.h what POSIX has without files or processes: for the page as well. */
#define _XOPEN_SOURCE 700
#include "system.h"

#ifndef _WIN32

#include <stdlib.h>

char *system_collect(void (*write)(FILE *out, const char *name), const char *name, size_t *length)
{
    char *text = NULL;
    FILE *out = open_memstream(&text, length);
    if (out == NULL) {
        return NULL;
    }
    write(out, name);
    if (fclose(out) != 0) {
        free(text);
        return NULL;
    }
    return text;
}

#endif
