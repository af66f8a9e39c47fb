/* SPDX-License-Identifier: MIT */
/*
 * Small triangles of a mesh of one colour, as most are: in surfaces of 16 bits with depth "less",
 * or "less or equal", and written, whose rows of pixels and of depths are equally far apart. Light
 * looks its pixel up in a table, which is made once a draw call.
 */
#include "../geometry/projector.h"
#include "../raster/list_values.h"
#include "../raster/loop.h"
#include "../raster/tint.h"
#include "fused.h"

/* What the rows of one have in common. Addresses are integers, since no pointer may lead from one
   array to another, nor to the left of one. */
typedef struct tint_rows {
    uintptr_t depths; /* of the column that spans count from */
    uintptr_t apart;  /* from a depth to its pixel */
    uintptr_t pitch;
    const uint16_t *table;
    uint32_t z, z_dx, z_dy;
    uint32_t light, light_dx, light_dy; /* the table's index begins at bit TABLE_SHIFT */
} tint_rows;

enum {
    TABLE_BITS = QTRI_TINT_BITS,
    TABLE_SHIFT = 22 - TABLE_BITS,
    TABLE_LENGTH = (1 << TABLE_BITS) + 4 /* a multiple of four, see encode_table() */
};

static inline uint16_t *at_address(uintptr_t address)
{
    return (uint16_t *)address; /* NOLINT(performance-no-int-to-ptr) */
}

/* Of the table's colours or of one pixel. */
QTRI_INLINE void fill(const tint_rows *rows, const uint8_t *span, uint32_t pixel, bool smooth,
                      bool equal)
{
    uint32_t z_row = rows->z;
    uint32_t z_step = rows->z_dx;
    uint32_t light_row = smooth ? rows->light : 0;
    uint32_t light_step = smooth ? rows->light_dx : 0;
    uintptr_t depths = rows->depths;
    const uintptr_t apart = rows->apart;
    for (;;) {
        const uint32_t x = span[0];
        const uint32_t end = span[1];
        span += 2;
        if (x < end) {
            uint32_t z = z_row + x * z_step;
            uint32_t light = light_row + x * light_step;
            uint16_t *at = at_address(depths + 2 * x);
            const uint16_t *stop = at_address(depths + 2 * end);
            const uint16_t *table = smooth ? rows->table : NULL;
            do {
                if (qtri_passes(z >> 16, *at, equal)) {
                    QTRI_BRANCH
                    *at = (uint16_t)(z >> 16);
                    *at_address((uintptr_t)at + apart) =
                        (uint16_t)(smooth ? table[light >> TABLE_SHIFT] : pixel);
                }
                z += z_step;
                light += light_step;
                at++;
                QTRI_OPAQUE(at)
                QTRI_ASIDE(z_step)
                QTRI_ASIDE(light_step)
            } while (at != stop);
        } else if (x == QTRI_PLACE_STOP) {
            return;
        }
        z_row += rows->z_dy;
        if (smooth) {
            light_row += rows->light_dy;
        }
        depths += rows->pitch;
    }
}

#ifdef __OPTIMIZE_SIZE__ /* where the stages draw them */
#define EQUAL(raster) false
#else
#define EQUAL(raster) ((raster)->compare == QTRI_LESS_EQUAL)
#endif

QTRI_NOINLINE static void fill_equal(const tint_rows *rows, const uint8_t *span, uint32_t pixel,
                                     bool smooth)
{
    if (smooth) {
        fill(rows, span, 0, true, true);
    } else {
        fill(rows, span, pixel, false, true);
    }
}

/* Colours of the format's kind as stored pixels. */
QTRI_NOINLINE static void encode_table(const qtri_raster *raster)
{
    uint16_t *table = raster->batch->by.table;
    uint32_t words[4];
    for (uint32_t i = 0; i < TABLE_LENGTH; i += 4) {
        for (uint32_t k = 0; k < 4; k++) {
            words[k] = table[i + k];
        }
        raster->format->encode(words, 4);
        for (uint32_t k = 0; k < 4; k++) {
            table[i + k] = (uint16_t)words[k];
        }
    }
}

/* Pixels of all shares of the tint: as qtri_raster_tinted() makes them, by sums, since a mesh may
   have few pixels. */
QTRI_NOINLINE static void make_table(const qtri_raster *raster)
{
    const qtri_colors *colors = raster->units;
    const uint32_t red = colors->red;
    const uint32_t green = colors->green;
    const uint32_t shift = 8 + TABLE_BITS;
    const uint32_t step[3] = {raster->tint_n8[0], raster->tint_n8[1], raster->tint_n8[2]};
    uint32_t r = (uint32_t)1 << (shift - 1); /* rounds */
    uint32_t g = r;
    uint32_t b = r;
    uint16_t *table = raster->batch->by.table;
    for (const uint16_t *end = table + TABLE_LENGTH; table != end; table++) {
        *table = (uint16_t)(r >> shift << red | g >> shift << green | b >> shift);
        r += step[0];
        g += step[1];
        b += step[2];
    }
    if (raster->format->encode != NULL) {
        encode_table(raster);
    }
    raster->batch->has_table = true;
}

bool qtri_tint_fits(const qtri_raster *raster)
{
    const qtri_surface *surface = raster->surface;
    return QTRI_WITH_FAST_PATHS && raster->format->pixels == &qtri_pixels_16 &&
           (raster->compare == QTRI_LESS || EQUAL(raster)) && raster->depth_write &&
           raster->effects == NULL && raster->route == NULL &&
           surface->pitch == 2 * surface->depth_pitch;
}

bool qtri_tint_draw(const qtri_raster *raster, const void *indices, qtri_vertex *a, qtri_vertex *b,
                    qtri_vertex *c)
{
    uint8_t spans[QTRI_PLACE_SPANS];
    qtri_place p;
#ifdef __OPTIMIZE_SIZE__
    const qtri_placed placed = qtri_place_triangle(&p, spans, raster, a, b, c);
#else
    const qtri_placed placed = qtri_place_inline(&p, spans, raster, a, b, c);
#endif
    if (placed != QTRI_PLACED_SMALL) {
        return placed == QTRI_PLACED_NOWHERE;
    }
    if (p.cut && !qtri_place_cut(p.first, p.column, &raster->bounds)) {
        return true;
    }
    uint32_t light_q15 = QTRI_VERTEX_UNLIT;
    if (!raster->lamp.by_vertex || !qtri_vertices_are_lit(a, b, c)) {
        light_q15 = raster->lamp.find(raster->lamp.from, indices, a, b, c);
    }
    const bool smooth = light_q15 == QTRI_VERTEX_UNLIT;
    const qtri_surface *surface = raster->surface;
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
    if (raster->batch->count != 0) {
        qtri_list_flush(raster);
    }
    QTRI_READ_AGAIN
    qtri_inverse_init(&inverse, p.size);
    if (!qtri_place_depth(&ramp, &p, &inverse, a, b, c, true)) {
        return false;
    }
    rows.z = ramp.origin;
    rows.z_dx = ramp.dx;
    rows.z_dy = ramp.dy;
    rows.pitch = (uintptr_t)surface->pitch;
    rows.apart = (uintptr_t)surface->pixels - (uintptr_t)surface->depth;
    rows.depths = (uintptr_t)surface->depth + (uintptr_t)p.row * rows.pitch +
                  (uintptr_t)(2 * (ptrdiff_t)p.column);
    if (!smooth) {
        rows.light = 0;
        rows.light_dx = 0;
        rows.light_dy = 0;
        rows.table = NULL;
        const uint32_t pixel =
            qtri_raster_stored(raster, qtri_raster_tinted(raster, light_q15, 15));
        if (EQUAL(raster)) {
            const tint_rows copy = rows; /* or all of it would be in memory */
            fill_equal(&copy, p.first, pixel, false);
        } else {
            fill(&rows, p.first, pixel, false, false);
        }
        return true;
    }
    if (!raster->batch->has_table) {
        make_table(raster);
    }
    qtri_place_ramp(&ramp, &p, &inverse,
                    ((uint32_t)a->intensity_q15 << 7) + ((uint32_t)1 << (TABLE_SHIFT - 1)),
                    (i1 + 1) >> (QTRI_PLACE_DOWN - 7), (i2 + 1) >> (QTRI_PLACE_DOWN - 7));
    rows.light = ramp.origin;
    rows.light_dx = ramp.dx;
    rows.light_dy = ramp.dy;
    rows.table = raster->batch->by.table;
    if (EQUAL(raster)) {
        const tint_rows copy = rows;
        fill_equal(&copy, p.first, 0, true);
        return true;
    }
    QTRI_READ_AGAIN
    fill(&rows, p.first, 0, true, false);
    return true;
}
