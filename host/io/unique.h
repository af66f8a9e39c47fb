/* SPDX-License-Identifier: MIT */
/*
 * Each distinct one of many items once, by their bytes.
 */
#ifndef QTRI_HOST_IO_UNIQUE_H
#define QTRI_HOST_IO_UNIQUE_H

#include <stddef.h>
#include <stdint.h>

/* All zero but for item_size at the beginning. */
struct unique {
    size_t item_size;
    void *items; /* in the order in which they came; who takes them sets NULL */
    size_t count, capacity;
    uint32_t *slots; /* an item's number + 1, or 0: open addressing */
    size_t slot_count;
};

/* The number of the item that is equal, new or known; there are fewer than 2^31. */
uint32_t unique_add(struct unique *set, const void *item);
void unique_free(struct unique *set);

/* Numbers the distinct ones of `count` items that are `stride` bytes apart: numbers[count]. Returns
   how many there are. */
size_t unique_numbers(const void *items, size_t count, size_t stride, size_t item_size,
                      uint32_t *numbers);

#endif
