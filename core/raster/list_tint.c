/* SPDX-License-Identifier: MIT */
/*
 * Small triangles of a mesh of one colour, as fast/list_one_color.c draws them, on their way to fog
 * or a blend: fragments go into the batch with their colour and depth. list.c does the same in more
 * steps: S4 takes a quarter more with it. Triangles are made ready as fast/list_one_color.c does
 * it, once more: where both call one inline function, plain S4 takes 2 % more on a Cortex-M3.
 */
#include "../geometry/projector.h"
#include "effect.h"
#include "list_values.h"
#include "tint.h"

enum { TABLE_BITS = QTRI_TINT_BITS, TABLE_SHIFT = 22 - TABLE_BITS };

bool qtri_list_tint_fits(const qtri_raster *raster)
{
#ifdef __OPTIMIZE_SIZE__ /* where the list is enough */
    (void)raster;
    return false;
#else
    return QTRI_WITH_FAST_PATHS && raster->texture == NULL && raster->route == NULL &&
           raster->depth_write && !raster->rejects &&
           (raster->compare == QTRI_LESS || raster->compare == QTRI_LESS_EQUAL);
#endif
}

#ifndef __OPTIMIZE_SIZE__
/* Where rows are, as integers: no pointer may lead to the left of one. */
typedef struct tint_rows {
    uintptr_t depths; /* of the column that spans count from */
    uintptr_t pitch;
    uint32_t place; /* of that column */
    uint32_t z, z_dx, z_dy;
    uint32_t light, light_dx, light_dy; /* Q22 */
    uint32_t shift;                     /* light's bits that a share has not */
    uint32_t equal;                     /* 1: what is as far passes */
    uint32_t color;                     /* of all, where light does not vary */
} tint_rows;

/* What a fragment's word is. */
typedef enum tint_word { ONE_COLOR, FROM_TABLE, SHARE } tint_word;

/* Appends the fragments that pass. */
QTRI_INLINE void follow(const tint_rows *rows, const uint8_t *span, qtri_batch *batch,
                        tint_word word)
{
    const uint16_t *table = batch->by.table;
    const uint32_t shift = word == SHARE ? rows->shift : 0;
    const bool varies = word != ONE_COLOR;
    const ptrdiff_t depth_at = batch->depth - batch->place;
    const ptrdiff_t color_at = batch->color - batch->place;
    uint32_t *next = batch->place + batch->count;
    uint32_t z_row = rows->z;
    uint32_t light_row = varies ? rows->light : 0;
    uint32_t place = rows->place;
    uintptr_t depths = rows->depths;
    for (;;) {
        const uint32_t x = span[0];
        const uint32_t end = span[1];
        span += 2;
        if (x < end) {
            uint32_t z = z_row + x * rows->z_dx;
            uint32_t light = varies ? light_row + x * rows->light_dx : 0;
            uint32_t at = place + x;
            uint16_t *stored = (uint16_t *)(depths + 2 * x); /* NOLINT(performance-no-int-to-ptr) */
            const uint16_t *const stop = stored + (end - x);
            do {
                if (z >> 16 < *stored + rows->equal) {
                    QTRI_BRANCH
                    *stored = (uint16_t)(z >> 16);
                    next[depth_at] = z;
                    next[color_at] = word == SHARE        ? light >> shift
                                     : word == FROM_TABLE ? table[light >> TABLE_SHIFT]
                                                          : rows->color;
                    *next++ = at;
                }
                z += rows->z_dx;
                light += rows->light_dx;
                at++;
                stored++;
                QTRI_OPAQUE(stored)
            } while (stored != stop);
        } else if (x == QTRI_PLACE_STOP) {
            break;
        }
        place += (uint32_t)1 << 16;
        z_row += rows->z_dy;
        light_row += rows->light_dy;
        depths += rows->pitch;
    }
    batch->count = (uint8_t)(next - batch->place);
}

QTRI_NOINLINE static void append_flat(const tint_rows *rows, const uint8_t *span, qtri_batch *batch)
{
    follow(rows, span, batch, ONE_COLOR);
}

QTRI_NOINLINE static void append_smooth(const tint_rows *rows, const uint8_t *span,
                                        qtri_batch *batch)
{
    follow(rows, span, batch, FROM_TABLE);
}

/* Finer colours, for which a table would be large: list.c makes them of shares. */
QTRI_NOINLINE static void append_shares(const tint_rows *rows, const uint8_t *span,
                                        qtri_batch *batch)
{
    follow(rows, span, batch, SHARE);
}

/* Colours of all shares of the tint: S4 at half alpha takes 5 to 6 % more without. */
QTRI_NOINLINE static void make_table(const qtri_raster *raster)
{
    for (uint32_t i = 0; i < (1u << TABLE_BITS) + 1; i++) {
        raster->batch->by.table[i] = (uint16_t)qtri_raster_tinted(raster, i, TABLE_BITS);
    }
    raster->batch->has_table = true;
}

bool qtri_list_tint(const qtri_raster *raster, const void *indices, qtri_vertex *a, qtri_vertex *b,
                    qtri_vertex *c)
{
    uint8_t spans[QTRI_PLACE_SPANS];
    qtri_place p;
    qtri_batch *batch = raster->batch;
    const qtri_surface *surface = raster->surface;
    const qtri_placed placed = qtri_place_inline(&p, spans, raster, a, b, c);
    if (placed != QTRI_PLACED_SMALL) {
        return placed == QTRI_PLACED_NOWHERE;
    }
    if (p.pixels > QTRI_BATCH) {
        return false;
    }
    if (p.cut && !qtri_place_cut(p.first, p.column, &raster->bounds)) {
        return true;
    }
    uint32_t light_q15 = QTRI_VERTEX_UNLIT;
    if (!raster->lamp.by_vertex || !qtri_vertices_are_lit(a, b, c)) {
        light_q15 = raster->lamp.find(raster->lamp.from, indices, a, b, c);
    }
    const bool smooth = light_q15 == QTRI_VERTEX_UNLIT;
    int32_t i1 = 0;
    int32_t i2 = 0;
    qtri_inverse inverse;
    qtri_ramp ramp;
    tint_rows rows;
    if (p.back) {
        qtri_vertex *swap = b;
        QTRI_RARELY();
        b = c;
        c = swap;
    }
    if (smooth) {
        const int32_t i0 = a->intensity_q15;
        i1 = b->intensity_q15 - i0;
        i2 = c->intensity_q15 - i0;
    }
    if (!qtri_list_is_plain(a, b, c, i1, i2, 3) &&
        !qtri_list_tint_is_simple(raster, a, b, c, i1, i2)) {
        return false;
    }
    QTRI_READ_AGAIN
    qtri_inverse_init(&inverse, p.size);
    if (!qtri_place_depth(&ramp, &p, &inverse, a, b, c, true)) {
        return false;
    }
    const uint8_t kind = smooth && raster->finer ? QTRI_LIST_TINT_SHARES : QTRI_LIST_COLORS;
    if (batch->kind != kind || p.pixels > QTRI_BATCH - batch->count) {
        qtri_list_flush(raster);
        batch->kind = kind;
    }
    batch->mask = UINT32_MAX;
    rows.equal = raster->compare == QTRI_LESS_EQUAL;
    rows.z = ramp.origin;
    rows.z_dx = ramp.dx;
    rows.z_dy = ramp.dy;
    rows.place = ((uint32_t)p.row << 16) + (uint32_t)p.column;
    rows.pitch = (uintptr_t)(2 * surface->depth_pitch);
    rows.depths = (uintptr_t)surface->depth +
                  (uintptr_t)(2 * ((ptrdiff_t)p.row * surface->depth_pitch + p.column));
    if (!smooth) {
        rows.light = 0;
        rows.light_dx = 0;
        rows.light_dy = 0;
        rows.color = qtri_raster_tinted(raster, light_q15, 15);
        append_flat(&rows, p.first, batch);
        return true;
    }
    rows.shift = raster->finer ? 22u - raster->units->light_bits : TABLE_SHIFT;
    if (!raster->finer && !batch->has_table) {
        make_table(raster);
    }
    qtri_place_ramp(&ramp, &p, &inverse,
                    ((uint32_t)a->intensity_q15 << 7) + ((uint32_t)1 << (rows.shift - 1)),
                    (i1 + 1) >> (QTRI_PLACE_DOWN - 7), (i2 + 1) >> (QTRI_PLACE_DOWN - 7));
    rows.light = ramp.origin;
    rows.light_dx = ramp.dx;
    rows.light_dy = ramp.dy;
    if (raster->finer) {
        append_shares(&rows, p.first, batch);
    } else {
        append_smooth(&rows, p.first, batch);
    }
    return true;
}
#else
bool qtri_list_tint(const qtri_raster *raster, const void *indices, qtri_vertex *a, qtri_vertex *b,
                    qtri_vertex *c)
{
    return raster == NULL && indices == a && b == c; /* never asked */
}
#endif
