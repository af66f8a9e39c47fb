/* SPDX-License-Identifier: MIT */
/* Of ../io/system.h what the page needs: there are no links to follow, and no signals. */
#define _XOPEN_SOURCE 700
#include <stdlib.h>
#include <string.h>

#include "../io/system.h"

char *system_real_path(const char *path)
{
    return strdup(path);
}

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
