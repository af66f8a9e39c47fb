/* SPDX-License-Identifier: MIT */
/*
 * Effects of small triangles: fragments of several of them wait in the batch, and may lie on each
 * other. What a blend reads is then what the one before has stored: so it gets as many at once as
 * lie on different pixels, which mostly are all.
 */
#include "effect.h"

#include <string.h>

#include "list_late.h"
#include "sampling.h"

/* Columns and rows that are told apart; those as far from each other are taken for the same. */
enum { COLUMNS = 32, ROWS = 16 };

/* How many of `count` fragments, from the first on, lie on different pixels: at least 1. */
QTRI_NOINLINE static int32_t different(const uint32_t *place, int32_t count)
{
    uint32_t seen[ROWS];
    memset(seen, 0, sizeof seen);
    for (int32_t i = 0; i < count; i++) {
        const uint32_t at = place[i];
        const uint32_t bit = (uint32_t)1 << (at & (COLUMNS - 1));
        uint32_t *row = &seen[at >> 16 & (ROWS - 1)];
        if ((*row & bit) != 0) {
            return i; /* not the first */
        }
        *row |= bit;
    }
    return count;
}

/* Of `count` fragments from `first` on, all of which lie on different pixels. */
static void apply(const qtri_raster *raster, int32_t first, uint32_t mask, int32_t count)
{
    qtri_batch *batch = raster->batch;
    uint32_t *color = batch->color + first;
    const uint32_t *place = batch->place + first;
    const qtri_fragments at = {place, *place, NULL, batch->depth + first};
    mask = raster->effects->fragments(raster, color, &at, mask, count);
    if (raster->rejects) {
        count = qtri_list_keep(raster, first, mask, count);
        if (count == 0) {
            return;
        }
    }
    qtri_list_store(raster, first, count);
}

/* Stages may change colours past the end of what they are given. */
enum { PAST = QTRI_BATCH_ROOM - QTRI_BATCH };

static void store(const qtri_raster *raster, uint32_t mask, int32_t count)
{
    uint32_t *const color = raster->batch->color;
    if (mask == 0) {
        return;
    }
    if (raster->effect_list != NULL && !raster->rejects) {
        raster->effect_list(raster, count);
        return;
    }
    for (int32_t first = 0; first < count;) {
        const int32_t rest = count - first;
        const int32_t some = raster->reads ? different(raster->batch->place + first, rest) : rest;
        // NOLINTNEXTLINE(clang-analyzer-core.*): `some` is at least 1
        const uint32_t drawn = mask >> (rest - some) & qtri_mask_of(some);
        uint32_t next[PAST];
        first += some;
        memcpy(next, color + first, sizeof next);
        if (drawn != 0) {
            apply(raster, first - some, drawn, some);
        }
        memcpy(color + first, next, sizeof next);
    }
}

const qtri_list_late qtri_list_late_effects = {qtri_list_note, store};
