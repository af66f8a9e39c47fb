/* SPDX-License-Identifier: MIT */
#include "array.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

void *array_grow(void *items, size_t count, size_t *capacity, size_t item_size)
{
    if (count < *capacity) {
        return items;
    }
    size_t larger = *capacity == 0 ? 16 : *capacity;
    if (larger > SIZE_MAX / 2 / item_size) {
        return NULL;
    }
    larger *= *capacity == 0 ? 1 : 2;
    void *moved = realloc(items, larger * item_size);
    if (moved != NULL) {
        *capacity = larger;
    }
    return moved;
}

void *array_add(void *items, size_t *count, size_t *capacity, size_t item_size)
{
    void *moved;
    memcpy(&moved, items, sizeof moved); /* of any type */
    moved = array_grow(moved, *count, capacity, item_size);
    if (moved == NULL) {
        return NULL;
    }
    memcpy(items, &moved, sizeof moved);
    return memset((char *)moved + (*count)++ * item_size, 0, item_size);
}
