/* SPDX-License-Identifier: MIT */
/*
 * Fragments on their way to pixels, some at a time. Internal.
 *
 *     place -> cover -> depth -> interpolate -> texel -> modulate -> store
 *              '--- per triangle ---'          '---- per batch ----'
 *
 * A stage is a loop over a batch: what varies from one draw call to the next is which stages are
 * called, chosen once, and never asked again for a pixel. Pixels of a row of a large triangle
 * (span.c) and pixels of several small ones (list.c) go through the same stages; only the last
 * differs, which stores a row or scatters.
 */
#ifndef QTRI_RASTER_BATCH_H
#define QTRI_RASTER_BATCH_H

#include "qtri/config.h"

#include "qtri/material.h"
#include "qtri/surface.h"

#include "../frame/colors.h"
#include "gradient.h"

enum {
    QTRI_BATCH = 32,                  /* fragments: as many as a mask has bits */
    QTRI_BATCH_ROOM = QTRI_BATCH + 7, /* stages work on four or eight at a time */
    QTRI_TINT_BITS = 7                /* of light, where colours are 565 */
};

/*
 * Words of a fragment, which stages replace in place.
 *
 *   color      the number of its texel, the stored texel, its colour, the stored pixel; where
 *              texels are filtered, at first u
 *   by.shade   what the texel is multiplied by: light, 0..1024, or red green blue, 10 bits each;
 *              where texels are filtered, at first v
 *   place      of small triangles: row << 16 | column, from the surface's first pixel
 */
typedef struct qtri_batch {
    uint8_t count;    /* fragments of small triangles that wait, see list.h */
    uint8_t kind;     /* what they are */
    bool has_table;   /* `by` is that, see fast/list_one_color.c */
    uint8_t alpha[3]; /* of a triangle's vertices, see blend_vertex.c */
    uint32_t mask;    /* of those that wait, which of them are drawn: see list.h */
    uint32_t color[QTRI_BATCH_ROOM];
    union {
        uint32_t shade[QTRI_BATCH_ROOM];
        uint16_t table[(1 << QTRI_TINT_BITS) + 4]; /* stored pixels: where there is no texture */
    } by;
    uint32_t place[QTRI_BATCH + 1]; /* and one that ends them */
    uint32_t
        depth[QTRI_BATCH]; /* of small triangles, where the raster keeps it: as a ramp has it */
} qtri_batch;

/* The batch's table. */
static inline uint16_t *qtri_batch_table(qtri_batch *batch)
{
    return batch->by.table;
}

/*
 * Leaves fragments out of the first `count` that are not in the mask; `write`: and writes the
 * depths of the others, 16.16 from place 0 on. Returns how many are left.
 */
int32_t qtri_batch_keep(qtri_batch *batch, const qtri_surface *surface, const qtri_ramp *depth,
                        uint32_t mask, int32_t count, bool write);

/* A material's comparison; a number that is none is QTRI_ALWAYS. Enums may be signed. */
static inline qtri_compare qtri_compare_of(const qtri_material *material)
{
    const qtri_compare compare = material->depth_compare;
    return (uint32_t)compare > (uint32_t)QTRI_ALWAYS ? QTRI_ALWAYS : compare;
}

/* Bits for less, equal and greater that a comparison has: they count in binary. */
static inline uint32_t qtri_orders_of(qtri_compare compare)
{
    return (uint32_t)compare - QTRI_NEVER;
}

/* The one of those bits that a depth has against what is stored. */
static inline uint32_t qtri_order_of(uint32_t depth, uint32_t stored)
{
    return depth < stored ? 1 : (depth == stored ? 2 : 4);
}

/* A mask of `count` fragments, 1..32: the first is its highest bit. */
static inline uint32_t qtri_mask_of(int32_t count)
{
    // NOLINTNEXTLINE(clang-analyzer-core.*): count is at least 1
    return UINT32_MAX >> (32 - count);
}

/* The pixel of a fragment at this place, on a surface of 16 bits. */
static inline uint16_t *qtri_placed_16(uint8_t *pixels, ptrdiff_t pitch, uint32_t place)
{
    uint16_t *row = (uint16_t *)(void *)(pixels + (ptrdiff_t)(place >> 16) * pitch);
    return row + (place & 0xFFFF);
}

#endif
