/* SPDX-License-Identifier: MIT */
#include "../frame/depth_format.h"
#include "batch.h"
#include "stroke_pixel.h"

/* Pixels of a row that one part covers: where they are, and what decides about them. */
typedef struct run {
    const qtri_stroker *stroker;
    const qtri_stroke_shape *shape;
    qtri_stroke_walk walk; /* at the first of them */
    uint8_t *pixel;
    uint32_t place; /* row << 16 | column of the first, counted from the surface's memory */
    int32_t count;  /* 1..QTRI_STROKE_WINDOW */
} run;

/* A bit for each pixel that passes, the lowest for the last; depths are of one value. */
static uint32_t test_level(const run *r, uint16_t *depth)
{
    const uint32_t passing = r->stroker->passing;
    const bool writes = r->stroker->depth_write;
    const uint16_t *end = depth + r->count;
    const uint32_t z = (qtri_stroke_depth(r->shape, 0) + 128) >> 8;
    uint32_t mask = 0;
    for (; depth != end; depth++) {
        const uint32_t passes = qtri_stroke_passes(passing, z, *depth);
        mask = mask << 1 | passes;
        if (passes != 0 && writes) {
            *depth = (uint16_t)z;
        }
    }
    return mask;
}

/* The same along the part. */
static uint32_t test_along(const run *r, uint16_t *depth)
{
    const uint32_t passing = r->stroker->passing;
    const bool writes = r->stroker->depth_write;
    const uint16_t *end = depth + r->count;
    qtri_stroke_walk walk = r->walk;
    uint32_t mask = 0;
    for (; depth != end; depth++) {
        const uint32_t z = (qtri_stroke_depth(r->shape, qtri_stroke_walk_next(&walk)) + 128) >> 8;
        const uint32_t passes = qtri_stroke_passes(passing, z, *depth);
        mask = mask << 1 | passes;
        if (passes != 0 && writes) {
            *depth = (uint16_t)z;
        }
    }
    return mask;
}

static uint32_t test_format(const run *r, const qtri_depth_testing *testing)
{
    const qtri_stroker *stroker = r->stroker;
    qtri_stroke_walk walk = r->walk;
    uint32_t mask = 0;
    for (int32_t i = 0; i < r->count; i++) {
        const uint32_t depth_16p8 = qtri_stroke_depth(r->shape, qtri_stroke_walk_next(&walk));
        mask =
            mask << 1 | testing->passes(stroker->surface, stroker->compare, r->place + (uint32_t)i,
                                        depth_16p8 << 8, stroker->depth_write);
    }
    return mask;
}

static uint32_t test(const run *r)
{
    const qtri_surface *surface = r->stroker->surface;
    if (r->stroker->compare == QTRI_DEPTH_OFF) {
        return qtri_mask_of(r->count);
    }
    const qtri_depth_testing *testing = qtri_depth_testing_of(surface);
    if (testing != NULL) {
        return test_format(r, testing);
    }
    uint16_t *depth = surface->depth + (ptrdiff_t)(r->place >> 16) * surface->depth_pitch +
                      (ptrdiff_t)(r->place & 0xFFFF);
    return r->shape->level ? test_level(r, depth) : test_along(r, depth);
}

/* One colour, stored as it is. */
static void fill(const run *r, uint32_t mask)
{
    const qtri_format *format = r->stroker->surface->format;
    uint32_t word[4] = {qtri_stroke_word(format, r->shape->end[0].color_8p16, r->pixel, 65536)};
    if (format->encode != NULL) {
        format->encode(word, 1);
    }
    format->pixels->fill(r->pixel, word[0], mask, r->count);
}

/* Colours along the part, or mixed with what is stored. */
static void store(const run *r, uint32_t mask)
{
    const qtri_stroke_shape *shape = r->shape;
    const qtri_format *format = r->stroker->surface->format;
    const int32_t share = qtri_stroke_share(r->stroker, QTRI_STROKE_FULL);
    const uint8_t *pixel = r->pixel;
    qtri_stroke_walk walk = r->walk;
    uint32_t word[QTRI_STROKE_WINDOW + 4] = {0};
    for (int32_t i = 0; i < r->count; i++, pixel += format->pixels->bytes) {
        int32_t color[3];
        const uint32_t share_q16 = shape->even ? 0 : qtri_stroke_walk_next(&walk);
        for (int k = 0; k < 3; k++) {
            color[k] = qtri_stroke_mixed(shape->end[0].color_8p16[k], shape->end[1].color_8p16[k],
                                         share_q16);
        }
        word[i] = qtri_stroke_word(format, color, pixel, share);
    }
    if (format->encode != NULL) {
        format->encode(word, r->count);
    }
    format->pixels->store(r->pixel, word, mask, r->count);
}

void qtri_stroke_run(const qtri_stroker *stroker, const qtri_stroke_shape *shape, int32_t first,
                     int32_t end)
{
    const qtri_surface *surface = stroker->surface;
    const int32_t row = stroker->row - surface->first_row;
    const run r = {stroker,
                   shape,
                   qtri_stroke_walk_from(shape, first * 256 + 128 - shape->origin.x_24p8,
                                         stroker->row * 256 + 128 - shape->origin.y_24p8),
                   surface->pixels + (ptrdiff_t)row * surface->pitch +
                       (ptrdiff_t)surface->format->pixels->bytes * first,
                   (uint32_t)row << 16 | (uint32_t)first,
                   end - first};
    const uint32_t mask = test(&r);
    if (mask == 0) {
        return;
    }
    if (shape->even && stroker->alpha == 255) {
        fill(&r, mask);
    } else {
        store(&r, mask);
    }
}
