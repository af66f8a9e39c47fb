/* SPDX-License-Identifier: MIT */
#include "xalloc.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

static void *checked(void *items)
{
    if (items == NULL) {
        xalloc_die();
    }
    return items;
}

void *xcalloc(size_t count, size_t size)
{
    return checked(calloc(count > 0 ? count : 1, size));
}

void *xrealloc(void *items, size_t count, size_t size)
{
    return checked(count > SIZE_MAX / size ? NULL : realloc(items, count * size));
}

char *xstrdup(const char *text)
{
    const size_t size = strlen(text) + 1;
    return memcpy(xcalloc(size, 1), text, size);
}
