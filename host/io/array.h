/* SPDX-License-Identifier: MIT */
/*
 * Arrays that grow.
 */
#ifndef QTRI_HOST_IO_ARRAY_H
#define QTRI_HOST_IO_ARRAY_H

#include <stddef.h>

/*
 * Makes room for one more item behind the `count` there are, doubling what it enlarges. Returns
 * where the items are now.
 */
void *array_grow(void *items, size_t count, size_t *capacity, size_t item_size);

/* Adds an item of zeros behind the *count items that the pointer at `items` names, and counts it.
 */
void *array_add(void *items, size_t *count, size_t *capacity, size_t item_size);

#endif
