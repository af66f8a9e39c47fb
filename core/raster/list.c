/* SPDX-License-Identifier: MIT */
#include "list.h"

#include "../geometry/projector.h"
#include "effect.h"
#include "list_late.h"
#include "list_values.h"
#include "sampling.h"
#include "shading.h"
#include "textured.h"

/* Rows on their way into the batch. */
typedef struct list_rows {
    uint8_t *span;
    uint32_t place;     /* of the base column in this row */
    uint32_t z;         /* there, 16.16 */
    ptrdiff_t depth_at; /* its depth's place in memory: may be left of a row */
    qtri_ramp depth;
} list_rows;

static void begin(list_rows *r, const qtri_raster *raster, const qtri_place *p,
                  const qtri_list_values *v)
{
    const qtri_surface *surface = raster->surface;
    r->span = p->first;
    r->place = ((uint32_t)p->row << 16) + (uint32_t)p->column;
    r->z = 0;
    r->depth_at = 0;
    qtri_list_set_depth(&r->depth, v);
    if (raster->with_depth) {
        r->z = qtri_list_at(&r->depth, (uint32_t)p->column, (uint32_t)p->row);
        r->depth_at = (ptrdiff_t)p->row * surface->depth_pitch + p->column;
    }
}

/*
 * Appends fragments of rows as long as there is room; where it ends, what is left of a row's span
 * waits. False at the end of the triangle. PIXELS are those from x to end of a row.
 */
#define APPEND_ROWS                                                                                \
    uint32_t *next = batch->place + batch->count;                                                  \
    const uint32_t *const stop = batch->place + QTRI_BATCH;                                        \
    uint8_t *span = r->span;                                                                       \
    bool more = false;                                                                             \
    for (;; span += 2) {                                                                           \
        const uint32_t x = span[0];                                                                \
        uint32_t end = span[1];                                                                    \
        if (x < end) {                                                                             \
            const uint32_t room = (uint32_t)(stop - next);                                         \
            if (end - x > room) {                                                                  \
                more = true;                                                                       \
                if (room == 0) {                                                                   \
                    break;                                                                         \
                }                                                                                  \
                end = x + room;                                                                    \
                span[0] = (uint8_t)end;                                                            \
            }                                                                                      \
            PIXELS                                                                                 \
            if (more) {                                                                            \
                break;                                                                             \
            }                                                                                      \
        } else if (x == QTRI_PLACE_STOP) {                                                         \
            break;                                                                                 \
        }                                                                                          \
        NEXT_ROW                                                                                   \
    }                                                                                              \
    r->span = span;                                                                                \
    batch->count = (uint8_t)(next - batch->place);                                                 \
    return more;

/* Without depth. */
static bool append_all(list_rows *r, qtri_batch *batch)
{
#define PIXELS                                                                                     \
    for (uint32_t at = r->place + x; at != r->place + end; at++) {                                 \
        *next++ = at;                                                                              \
    }
#define NEXT_ROW r->place += (uint32_t)1 << 16;
    APPEND_ROWS
#undef PIXELS
#undef NEXT_ROW
}

#define NEXT_ROW                                                                                   \
    r->place += (uint32_t)1 << 16;                                                                 \
    r->z += r->depth.dy;                                                                           \
    r->depth_at += surface->depth_pitch;

/* Depth less, written. */
static bool append_less(list_rows *r, qtri_batch *batch, const qtri_surface *surface)
{
    // NOLINTNEXTLINE(clang-analyzer-core.*): with a depth test, begin() has set depths
    uint32_t step = r->depth.dx;
#define PIXELS                                                                                     \
    uint32_t z = r->z + x * step;                                                                  \
    uint32_t at = r->place + x;                                                                    \
    uint16_t *depth = &surface->depth[r->depth_at + (int32_t)x];                                   \
    const uint16_t *const row_end = depth + (end - x);                                             \
    do {                                                                                           \
        if (z >> 16 < *depth) {                                                                    \
            QTRI_BRANCH                                                                            \
            *depth = (uint16_t)(z >> 16);                                                          \
            *next++ = at;                                                                          \
        }                                                                                          \
        z += step;                                                                                 \
        at++;                                                                                      \
        depth++;                                                                                   \
        QTRI_OPAQUE(depth)                                                                         \
        QTRI_ASIDE(step)                                                                           \
    } while (depth != row_end);
    APPEND_ROWS // NOLINT(clang-analyzer-core.*): with a depth test, begin() has set depths
#undef PIXELS
}

#ifndef __OPTIMIZE_SIZE__
/*
 * The same of a triangle with room for all of its pixels, as most have: what changes from row to
 * row stays in registers, which saves meshes 1 % on a Cortex-M0+ and 2 to 3 % on an M3. Addresses
 * are integers, since no pointer may lead to the left of a row.
 */
static void append_few(const list_rows *r, qtri_batch *batch, const qtri_surface *surface)
{
    const uint8_t *span = r->span;
    uint32_t *next = batch->place + batch->count;
    uint32_t place = r->place;
    uint32_t z_row = r->z;
    // NOLINTNEXTLINE(clang-analyzer-core.*): with a depth test, begin() has set depths
    uint32_t step = r->depth.dx;
    const uint32_t dy = r->depth.dy;
    const uintptr_t pitch = (uintptr_t)(2 * surface->depth_pitch);
    uintptr_t depths = (uintptr_t)surface->depth + (uintptr_t)(2 * r->depth_at);
    for (;;) {
        const uint32_t x = span[0];
        const uint32_t end = span[1];
        span += 2;
        if (x < end) {
            uint32_t z = z_row + x * step;
            uint32_t at = place + x;
            uint16_t *depth = (uint16_t *)(depths + 2 * x); /* NOLINT(performance-no-int-to-ptr) */
            const uint16_t *const row_end = depth + (end - x);
            do {
                if (z >> 16 < *depth) {
                    QTRI_BRANCH
                    *depth = (uint16_t)(z >> 16);
                    *next++ = at;
                }
                z += step;
                at++;
                depth++;
                QTRI_OPAQUE(depth)
                QTRI_ASIDE(step)
            } while (depth != row_end);
        } else if (x == QTRI_PLACE_STOP) {
            break;
        }
        place += (uint32_t)1 << 16;
        z_row += dy;
        depths += pitch;
    }
    batch->count = (uint8_t)(next - batch->place);
}
#endif

/* Any comparison: `passes` has bits for less, equal, greater. */
static bool append_passing(list_rows *r, qtri_batch *batch, const qtri_surface *surface,
                           uint32_t passes, bool write)
{
#define PIXELS                                                                                     \
    uint32_t z = r->z + x * r->depth.dx;                                                           \
    uint32_t at = r->place + x;                                                                    \
    uint16_t *depth = &surface->depth[r->depth_at + (int32_t)x];                                   \
    const uint16_t *const row_end = depth + (end - x);                                             \
    do {                                                                                           \
        const uint32_t top = z >> 16;                                                              \
        const uint32_t stored = *depth;                                                            \
        if ((passes & qtri_order_of(top, stored)) != 0) {                                          \
            QTRI_BRANCH                                                                            \
            if (write) {                                                                           \
                *depth = (uint16_t)top;                                                            \
            }                                                                                      \
            *next++ = at;                                                                          \
        }                                                                                          \
        z += r->depth.dx;                                                                          \
        at++;                                                                                      \
        depth++;                                                                                   \
    } while (depth != row_end);
    APPEND_ROWS // NOLINT(clang-analyzer-core.*): with a depth test, begin() has set depths
#undef PIXELS
}

/* `pixels`: there are no more. `late`: depths are written with the pixels. */
static bool append(list_rows *r, const qtri_raster *raster, int32_t pixels, bool late)
{
    const qtri_surface *surface = raster->surface;
    qtri_batch *batch = raster->batch;
    if (raster->compare == QTRI_DEPTH_OFF) {
        return append_all(r, batch);
    }
    const bool write = raster->depth_write && !late;
    if (raster->compare == QTRI_LESS && write) {
#ifdef __OPTIMIZE_SIZE__
        (void)pixels;
#else
        if (pixels <= QTRI_BATCH - batch->count) {
            append_few(r, batch, surface);
            return false;
        }
#endif
        return append_less(r, batch, surface);
    }
    return append_passing(r, batch, surface, qtri_orders_of(raster->compare), write);
}

/* Light becomes its share of the tint: within .75 of a step of RGB565, .63 of 255. */
static void share_tint(const qtri_raster *raster, uint32_t *color, int32_t count)
{
    const qtri_colors *colors = raster->units;
    const uint32_t shift = 8 + colors->light_bits;
    const uint32_t half = (uint32_t)1 << (shift - 1);
    const uint32_t *const end = color + count;
    const uint32_t b = raster->tint_n8[2];
    if (colors->single) {
        for (; color != end; color++) {
            *color = (*color * b + half) >> shift;
        }
        return;
    }
    const uint32_t red = colors->red;
    const uint32_t green = colors->green;
    const uint32_t r = raster->tint_n8[0];
    const uint32_t g = raster->tint_n8[1];
    for (; color != end; color++) {
        const uint32_t light = *color;
        *color = (light * r + half) >> shift << red | (light * g + half) >> shift << green |
                 (light * b + half) >> shift;
    }
}

/* The stages of what is in the batch, one fragment at least. */
static void finish(const qtri_raster *raster)
{
    qtri_batch *batch = raster->batch;
    uint32_t mask = raster->late != NULL ? batch->mask : UINT32_MAX;
    int32_t count = batch->count;
    batch->count = 0;
    batch->mask = 0;
    if (raster->lit_list != NULL && batch->kind == QTRI_LIST_LIT_TEXELS) {
        raster->lit_list(raster, count);
        return;
    }
    if (raster->texture != NULL) {
        mask = raster->texturing->finish_list(raster, count, mask);
    } else if (batch->kind == QTRI_LIST_TINT_SHARES) {
        share_tint(raster, batch->color, count);
    }
    if (raster->samples != NULL || raster->late != NULL) {
        const qtri_draw_masked *put =
            raster->samples != NULL ? &raster->samples->put : &raster->late->store;
        (*put)(raster, mask & qtri_mask_of(count), count);
        return;
    }
    const qtri_format *format = raster->format;
    if (format->encode != NULL) {
        format->encode(batch->color, count);
    }
    format->pixels->scatter(raster->surface->pixels, raster->surface->pitch, batch->place,
                            batch->color, count);
}

void qtri_list_flush(const qtri_raster *raster)
{
    if (raster->batch->count != 0) {
        finish(raster);
    }
}

/* Colours; returns what the words are. */
QTRI_INLINE uint8_t set_colors(qtri_list_values *v)
{
    const qtri_raster *raster = v->raster;
    const qtri_list_triangle *t = v->t;
    const qtri_colors *units = raster->units;
    const uint8_t now = raster->batch->kind;
    v->channels = 0;
    if (raster->texture == NULL) {
        if (!raster->smooth || !qtri_list_varies(t)) {
            v->constant = qtri_list_flat_color(raster, t);
            return QTRI_LIST_COLORS;
        }
        if (t->color == NULL) {
            raster->varying->set_light(v, 22u - units->light_bits);
            return QTRI_LIST_TINT_SHARES;
        }
        raster->varying->set_channels(v, 16);
        return QTRI_LIST_COLORS;
    }
    if (raster->replace) {
        return QTRI_LIST_TEXELS;
    }
    if (t->color == NULL) {
        raster->varying->set_light(v, QTRI_LIGHT_SHIFT);
        return now != QTRI_LIST_LIT_TEXELS && v->channels == 0 && v->constant == 1024 &&
                       raster->white
                   ? QTRI_LIST_TEXELS
                   : QTRI_LIST_LIT_TEXELS;
    }
    if (raster->smooth && !qtri_list_is_one_color(t)) {
        raster->varying->set_channels(v, QTRI_CHANNEL_SHIFT);
        return QTRI_LIST_RGB_TEXELS;
    }
    v->constant = qtri_list_flat_shade(raster, t);
    if (v->constant == QTRI_SHADE_WHITE && now != QTRI_LIST_RGB_TEXELS) {
        return QTRI_LIST_TEXELS;
    }
    return QTRI_LIST_RGB_TEXELS;
}

/* The words of fragments first..count - 1. Returns the mask of those that are drawn. */
QTRI_INLINE uint32_t set_words(const qtri_list_values *v, int32_t first, int32_t count)
{
    const qtri_raster *raster = v->raster;
    const qtri_colors *units = raster->units;
    qtri_batch *batch = raster->batch;
    const uint32_t *place = batch->place + first;
    uint32_t *color = batch->color + first;
    batch->place[count] = *place ^ (uint32_t)1 << 31; /* far from all: it ends a piece of a row */
    count -= first;
    if (raster->texture != NULL) {
        return raster->texturing->color_list(v, color, batch->by.shade + first, place, count);
    }
    if (v->channels == 0) {
        for (int32_t i = 0; i < count; i++) {
            color[i] = v->constant;
        }
    } else if (batch->kind == QTRI_LIST_TINT_SHARES) {
        raster->varying->words(v, color, place, count, 22u - units->light_bits, 0, 0);
    } else {
        raster->varying->words(v, color, place, count, 16, units->red, units->green);
    }
    return UINT32_MAX;
}

QTRI_NOINLINE void qtri_list_draw(const qtri_raster *raster, const qtri_list_triangle *t)
{
    qtri_batch *batch = raster->batch;
    qtri_list_values v;
    list_rows r;
    bool more;
    bool set = false;
    if (t->place->cut && !qtri_place_cut(t->place->first, t->place->column, &raster->bounds)) {
        return;
    }
    qtri_list_begin(&v, raster, t);
    t->place->x -= t->place->column * 256;
    t->place->y -= t->place->row * 256;
    begin(&r, raster, t->place, &v);
    const uint8_t kind = set_colors(&v);
    if (kind != batch->kind) {
        qtri_list_flush(raster);
        batch->kind = kind;
    }
    do {
        const int32_t first = batch->count;
        more = append(&r, raster, t->place->pixels, raster->rejects);
        if (batch->count > first) {
            if (!set && raster->texture != NULL) {
                raster->texturing->set_list(&v);
            }
            set = true;
            const int32_t count = batch->count - first;
            const uint32_t mask = set_words(&v, first, batch->count);
            if (raster->late != NULL) {
                raster->late->note(raster, &r.depth, mask, count);
                if (raster->apart) {
                    finish(raster);
                }
            }
        }
        if (more) {
            qtri_list_flush(raster);
        }
    } while (more);
    if (batch->count > 16) {
        qtri_list_flush(raster);
    }
}

void qtri_list_set(qtri_list_values *v)
{
    const qtri_raster *raster = v->raster;
    const uint8_t kind = set_colors(v);
    if (kind != raster->batch->kind) {
        qtri_list_flush(raster);
        raster->batch->kind = kind;
    }
    if (raster->texture != NULL) {
        raster->texturing->set_list(v);
    }
}

uint32_t qtri_list_append(const qtri_list_values *v, int32_t count)
{
    qtri_batch *batch = v->raster->batch;
    const int32_t first = batch->count;
    batch->count = (uint8_t)(first + count);
    return set_words(v, first, first + count);
}
