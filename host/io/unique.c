/* SPDX-License-Identifier: MIT */
#include "unique.h"

#include <stdlib.h>
#include <string.h>

#include "array.h"
#include "xalloc.h"

/* Multiply and shift after each word: neighbours on a grid differ in few bits. */
static size_t hash(const void *item, size_t size)
{
    uint64_t h = size;
    for (size_t at = 0; at < size; at += sizeof(uint32_t)) {
        uint32_t word = 0;
        memcpy(&word, (const char *)item + at, size - at < sizeof word ? size - at : sizeof word);
        h = (h ^ word) * UINT64_C(0x9E3779B97F4A7C15);
        h ^= h >> 29;
    }
    return (size_t)h;
}

/* The slot that holds an equal item, or the free one where it belongs. The table is never full. */
static uint32_t *find_slot(const struct unique *set, const void *item)
{
    const char *items = set->items;
    size_t at = hash(item, set->item_size) & (set->slot_count - 1);
    while (set->slots[at] != 0 &&
           // NOLINTNEXTLINE(clang-analyzer-core.NonNullParamChecker): there are items then
           memcmp(items + (set->slots[at] - 1) * set->item_size, item, set->item_size) != 0) {
        at = (at + 1) & (set->slot_count - 1);
    }
    return &set->slots[at];
}

static void grow_slots(struct unique *set)
{
    free(set->slots);
    set->slot_count = set->slot_count == 0 ? 64 : 2 * set->slot_count;
    set->slots = xcalloc(set->slot_count, sizeof *set->slots);
    for (size_t i = 0; i < set->count; i++) {
        *find_slot(set, (const char *)set->items + i * set->item_size) = (uint32_t)(i + 1);
    }
}

uint32_t unique_add(struct unique *set, const void *item)
{
    if (2 * (set->count + 1) > set->slot_count) {
        grow_slots(set);
    }
    uint32_t *slot = find_slot(set, item);
    if (*slot == 0) {
        set->items = array_grow(set->items, set->count, &set->capacity, set->item_size);
        memcpy((char *)set->items + set->count * set->item_size, item, set->item_size);
        *slot = (uint32_t)++set->count;
    }
    return *slot - 1;
}

void unique_free(struct unique *set)
{
    free(set->items);
    free(set->slots);
    memset(set, 0, sizeof *set);
}

size_t unique_numbers(const void *items, size_t count, size_t stride, size_t item_size,
                      uint32_t *numbers)
{
    struct unique set = {.item_size = item_size};
    for (size_t i = 0; i < count; i++) {
        numbers[i] = unique_add(&set, (const char *)items + i * stride);
    }
    const size_t distinct = set.count;
    unique_free(&set);
    return distinct;
}
