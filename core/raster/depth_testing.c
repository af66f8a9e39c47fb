/* SPDX-License-Identifier: MIT */
/*
 * Depths of another format than linear16.
 *
 * They are tested as an effect is applied (effect.h): after the colours of a batch, which holds
 * fragments of one triangle or of a piece of one line, before fog and blend, and written after
 * those. To all stages before it the surface is one without depth. So nothing else of triangles
 * knows of such formats, no loop for linear16 asks for them, and triangles of all sizes, textures
 * and blends have them alike. The price is that colours are made of fragments that are hidden.
 */
#include "../frame/depth_format.h"
#include "../frame/fill.h"
#include "../frame/stored.h"
#include "batch.h"
#include "depth_rows.h"
#include "effect.h"
#include "job.h"
#include "list_values.h"
#include "loop.h"
#include "sampling.h"
#include "words.h"

/* Of neighbours: those between two that are in range are as well. */
static void set_row(uint32_t *depth, uint32_t z, uint32_t step, int32_t count)
{
    const uint32_t first = z - QTRI_DEPTH_HALF;
    const uint32_t last = first + (uint32_t)(count - 1) * step;
    if (first > QTRI_DEPTH_FARTHEST || last > QTRI_DEPTH_FARTHEST) {
        for (int32_t i = 0; i < count; i++, z += step) {
            depth[i] = qtri_depth_of(z);
        }
        return;
    }
    z = first;
    for (const uint32_t *end = depth + count; depth < end; depth += 4) { /* up to QTRI_BATCH */
        depth[0] = z;
        z += step;
        depth[1] = z;
        z += step;
        depth[2] = z;
        z += step;
        depth[3] = z;
        z += step;
    }
}

static void set_depths(uint32_t *depth, const qtri_fragments *at, int32_t count)
{
    const qtri_ramp *ramp = at->depth;
    if (at->place != NULL && at->depths != NULL) {
        for (int32_t i = 0; i < count; i++) {
            depth[i] = qtri_depth_of(at->depths[i]);
        }
        return;
    }
    if (at->place != NULL) {
        for (int32_t i = 0; i < count; i++) {
            depth[i] = qtri_depth_of(qtri_list_at(ramp, at->place[i] & 0xFFFF, at->place[i] >> 16));
        }
        return;
    }
    set_row(depth, qtri_list_at(ramp, at->first & 0xFFFF, at->first >> 16), ramp->dx, count);
}

/* Where a fragment's depth is stored. */
static inline uint8_t *stored_at(const qtri_surface *surface, uint32_t place)
{
    const ptrdiff_t bytes = surface->depth_format->bytes;
    return (uint8_t *)surface->depth +
           bytes * ((ptrdiff_t)(place >> 16) * surface->depth_pitch + (ptrdiff_t)(place & 0xFFFF));
}

/*
 * Of the mask's fragments those that pass; `writes`: and their depths are stored. bytes and is_row
 * are constants where time counts.
 */
QTRI_INLINE uint32_t test(const qtri_surface *surface, uint32_t orders, const uint32_t *depth,
                          const qtri_fragments *at, uint32_t mask, int32_t count, bool writes,
                          int32_t bytes, bool is_row)
{
    const ptrdiff_t pitch = surface->depth_pitch * bytes;
    const uint32_t *place = at->place;
    uint8_t *const first = (uint8_t *)surface->depth;
    uint8_t *to = is_row ? stored_at(surface, at->first) : first;
    uint32_t passed = 0;
    for (mask <<= 32 - count; count > 0; count--, mask <<= 1, depth++) {
        passed <<= 1;
        if ((int32_t)mask < 0) {
            if (!is_row) {
                to = first + (ptrdiff_t)(*place >> 16) * pitch +
                     (ptrdiff_t)(*place & 0xFFFF) * bytes;
            }
            if ((orders & qtri_order_of(*depth, qtri_stored_get(bytes, to))) != 0) {
                passed |= 1;
                if (writes) {
                    qtri_stored_put(bytes, to, *depth);
                }
            }
        }
        if (is_row) {
            to += bytes;
        } else {
            place++;
        }
    }
    return passed;
}

/* A function of its own, so that its stack is free again when fog and blend take theirs. */
QTRI_NOINLINE static uint32_t test_all(const qtri_surface *surface, qtri_compare compare,
                                       const qtri_fragments *at, uint32_t mask, int32_t count,
                                       bool writes)
{
    const uint32_t orders = qtri_orders_of(compare);
    const int32_t bytes = surface->depth_format->bytes;
    uint32_t depth[QTRI_BATCH];
    set_depths(depth, at, count);
    surface->depth_format->encode(depth, count);
    if (at->place != NULL) {
        return test(surface, orders, depth, at, mask, count, writes, bytes, false);
    }
    return test(surface, orders, depth, at, mask, count, writes, bytes, true);
}

/* Of a row, where the format has a loop for that. */
static uint32_t test_any(const qtri_surface *surface, qtri_compare compare,
                         const qtri_fragments *at, uint32_t mask, int32_t count, bool writes)
{
    const qtri_depth_row row = surface->depth_format->testing->row;
    if (at->place != NULL || row == NULL) {
        return test_all(surface, compare, at, mask, count, writes);
    }
    const uint32_t z = qtri_list_at(at->depth, at->first & 0xFFFF, at->first >> 16);
    return row(stored_at(surface, at->first), z, at->depth->dx, mask, count,
               qtri_orders_of(compare), writes);
}

/* Fog and blend; NULL: neither. */
static const qtri_effect_stages *others_of(const qtri_raster *raster)
{
    if (raster->fog != NULL) {
        return raster->fog->stages->effects;
    }
    return raster->blend != NULL ? raster->blend->effects : NULL;
}

static uint32_t apply(const qtri_raster *raster, uint32_t *color, const qtri_fragments *at,
                      uint32_t mask, int32_t count)
{
    const qtri_surface *surface = raster->surface;
    const qtri_effect_stages *after = others_of(raster);
    const bool early = raster->blend == NULL || !raster->blend->rejects; /* the mask is the last */
    const bool writes = raster->late_write;
    mask = test_any(surface, raster->late_compare, at, mask, count, early && writes);
    if (after != NULL && mask != 0) {
        mask = after->fragments(raster, color, at, mask, count);
        if (!early && writes && mask != 0) {
            (void)test_any(surface, QTRI_ALWAYS, at, mask, count, true);
        }
    }
    return mask;
}

/* Pixels of a row in one colour, stored as `pixel`. */
static void fill_row(const qtri_job *job, int32_t x, int32_t y, int32_t rest, uint32_t pixel)
{
    const qtri_raster *raster = job->raster;
    const qtri_surface *surface = raster->surface;
    const qtri_pixels *memory = raster->format->pixels;
    const int32_t bytes = surface->depth_format->bytes;
    const qtri_depth_row test_row = surface->depth_format->testing->row;
    const uint32_t orders = qtri_orders_of(raster->late_compare);
    const uint32_t step = job->depth.dx;
    uint32_t z = qtri_ramp_at(&job->depth, x - job->anchor_x, y - job->anchor_y);
    uint8_t *depth = stored_at(surface, ((uint32_t)(y - surface->first_row) << 16) + (uint32_t)x);
    uint8_t *pixels = qtri_pixels_at(surface, y) + (ptrdiff_t)x * memory->bytes;
    const qtri_depth_flat flat = surface->depth_format->testing->flat;
    if (flat != NULL && (orders == 1 || orders == 3) && raster->late_write &&
        memory == &qtri_pixels_16) {
        flat((uint16_t *)(void *)depth, (uint16_t *)(void *)pixels, z, step, rest, (uint16_t)pixel,
             orders == 3);
        return;
    }
    while (rest > 0) {
        const int32_t count = qtri_least32(rest, QTRI_BATCH);
        const uint32_t mask =
            test_row(depth, z, step, qtri_mask_of(count), count, orders, raster->late_write);
        if (mask != 0) {
            memory->fill(pixels, pixel, mask, count);
        }
        rest -= count;
        depth += count * bytes;
        pixels += (ptrdiff_t)count * memory->bytes;
        z += (uint32_t)count * step;
    }
}

/*
 * Rows of one colour that nothing follows are tested before they are filled. Jobs that have
 * textures, colours that vary, or light by pixel have other loops.
 */
static void fill_rows(const qtri_job *job, const qtri_span *spans, int32_t row, int32_t count)
{
    const qtri_raster *raster = job->raster;
    uint32_t pixel[4] = {job->pixel};
    if (raster->format->encode != NULL) {
        raster->format->encode(pixel, 1);
    }
    for (const qtri_span *end = spans + count; spans != end; spans++, row++) {
        int32_t x;
        const int32_t pixels = qtri_span_clip(spans, &raster->bounds, &x);
        if (pixels > 0) {
            fill_row(job, x, row, pixels, pixel[0]);
        }
    }
}

const qtri_effect_stages qtri_depth_effects = {apply, qtri_line_effects, qtri_span_fill, NULL,
                                               &qtri_list_late_effects};
static const qtri_effect_stages filled = {apply, qtri_line_effects, fill_rows, NULL,
                                          &qtri_list_late_effects};

void qtri_depth_begin(qtri_raster *raster)
{
    if (raster->compare == QTRI_DEPTH_OFF) {
        return;
    }
    if (qtri_sampling_of(raster->surface->format) != NULL) {
        raster->compare = QTRI_NEVER; /* records have room for linear16 alone: nothing is drawn */
        return;
    }
    if (raster->compare == QTRI_NEVER) {
        return;
    }
    raster->late_compare = raster->compare;
    raster->late_write = raster->depth_write;
    const bool is_last = others_of(raster) == NULL;
    raster->effects = is_last && raster->surface->depth_format->testing->row != NULL
                          ? &filled
                          : &qtri_depth_effects;
    raster->compare = QTRI_DEPTH_OFF;
    raster->depth_write = false;
    raster->with_depth = true;
    raster->late = qtri_depth_effects.late;
    raster->apart = false;
    raster->keeps_depth = true;
    raster->rejects = true;
}

/* Each chunk of a line ends its batch. */
void qtri_depth_begin_lines(qtri_line_job *job, qtri_compare compare)
{
    if (job->surface->depth != NULL && compare != QTRI_DEPTH_OFF) {
        job->testing = &qtri_depth_testing_stages;
        job->effect = qtri_line_effects;
        job->draw = qtri_line_draw_apart;
        job->has_depth = false;
    }
}

uint32_t qtri_depth_test_chunk(const qtri_raster *raster, const qtri_fragments *at, uint32_t mask,
                               int32_t count)
{
    return test_any(raster->surface, raster->late_compare, at, mask, count, raster->late_write);
}

/* Depths move towards the first: what is read was not written yet. */
uint16_t *qtri_depth_flatten(const qtri_surface *surface)
{
    const qtri_depth_format *format = surface->depth_format;
    const int32_t bytes = format->bytes;
    const ptrdiff_t pitch = surface->depth_pitch < 0 ? -surface->depth_pitch : surface->depth_pitch;
    uint8_t *first = (uint8_t *)surface->depth;
    if (surface->depth_pitch < 0) {
        first -= bytes * pitch * (surface->rows - 1);
    }
    uint16_t *to = (uint16_t *)(void *)first;
    for (int32_t row = 0; row < surface->rows; row++) {
        for (int32_t x = 0; x < surface->width; x += QTRI_BATCH) {
            uint32_t depth[QTRI_BATCH];
            const int32_t count = qtri_least32(QTRI_BATCH, surface->width - x);
            const ptrdiff_t at = row * pitch + x;
            for (int32_t i = 0; i < count; i++) {
                depth[i] = qtri_stored_get(bytes, first + bytes * (at + i));
            }
            format->decode(depth, count);
            for (int32_t i = 0; i < count; i++) {
                to[at + i] = (uint16_t)((depth[i] < QTRI_DEPTH_FARTHEST ? depth[i] + QTRI_DEPTH_HALF
                                                                        : QTRI_DEPTH_FARTHEST) >>
                                        16);
            }
        }
    }
    return to;
}

/* Depths, as pixels of a surface. */
void qtri_depth_fill(const qtri_surface *surface, const qtri_rect *rect, uint32_t depth_16p16)
{
    const qtri_pixels memory = {surface->depth_format->bytes, NULL, NULL, NULL, NULL};
    const qtri_format format = {&memory, NULL, NULL, NULL, NULL, 0};
    qtri_surface depths = *surface;
    depths.format = &format;
    depths.pixels = (uint8_t *)surface->depth;
    depths.pitch = memory.bytes * surface->depth_pitch;
    surface->depth_format->encode(&depth_16p16, 1);
    qtri_fill_rect(&depths, rect, depth_16p16);
}

const qtri_depth_testing qtri_depth_testing_stages = QTRI_DEPTH_TESTING(NULL, NULL);
