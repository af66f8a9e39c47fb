/* SPDX-License-Identifier: MIT */
#include "array.h"

#include <string.h>

#include "xalloc.h"

void *array_grow(void *items, size_t count, size_t *capacity, size_t item_size)
{
    if (count < *capacity) {
        return items;
    }
    *capacity = *capacity == 0 ? 16 : 2 * *capacity;
    return xrealloc(items, *capacity, item_size);
}

void *array_add(void *items, size_t *count, size_t *capacity, size_t item_size)
{
    void *moved;
    memcpy(&moved, items, sizeof moved); /* of any type */
    moved = array_grow(moved, *count, capacity, item_size);
    memcpy(items, &moved, sizeof moved);
    return memset((char *)moved + (*count)++ * item_size, 0, item_size);
}
