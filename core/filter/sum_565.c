/* SPDX-License-Identifier: MIT */
/*
 * Sums of frames in lanes of a word; see sum.c and mix.h.
 */
#include "qtri/filters.h"
#include "qtri/error.h"

#include "../frame/barrier.h"
#include "mix.h"

/* The rows and columns that count; false: there is an error, or nothing to do. */
static bool begin(const qtri_surface *surface, const uint32_t *sums, uint32_t words,
                  qtri_rect *bounds, enum qtri_error *error)
{
    QTRI_ASSERT(sums != NULL || words == 0);
    *bounds = qtri_surface_bounds(surface);
    *error = QTRI_OK;
    if (bounds->x0 >= bounds->x1) {
        return false;
    }
    if (!qtri_is_565(surface->format)) {
        *error = QTRI_ERROR_FORMAT;
    } else if (sums == NULL || words < QTRI_SUM_565_WORDS(surface->width, surface->rows)) {
        *error = QTRI_ERROR_MEMORY;
    }
    return *error == QTRI_OK;
}

#define ADD(i)                                                                                     \
    {                                                                                              \
        const uint32_t color = pixel[i];                                                           \
        sum[i] += (color | color << 16) & lanes;                                                   \
        QTRI_OPAQUE(sum)                                                                           \
    }

QTRI_NOINLINE static void add_row(uint32_t *sum, const uint16_t *pixel, int32_t count)
{
    uint32_t lanes = QTRI_LANES_565;
    QTRI_OPAQUE(lanes)
    for (; count >= 4; count -= 4, sum += 4, pixel += 4) {
        ADD(0)
        ADD(1)
        ADD(2)
        ADD(3)
    }
    for (; count > 0; count--, sum++, pixel++) {
        ADD(0)
    }
}

#define STORE(i)                                                                                   \
    {                                                                                              \
        uint32_t mean = ((sum[i] + half) >> log2) & lanes;                                         \
        mean |= mean >> 16;                                                                        \
        pixel[i] = (uint16_t)mean;                                                                 \
        QTRI_OPAQUE(pixel)                                                                         \
    }

QTRI_NOINLINE static void store_row(uint16_t *pixel, const uint32_t *sum, int32_t count,
                                    uint32_t log2)
{
    uint32_t lanes = QTRI_LANES_565;
    /* Half of a step in each lane. */
    const uint32_t half = log2 == 0 ? 0 : (uint32_t)0x00200801 << (log2 - 1);
    QTRI_OPAQUE(lanes)
    for (; count >= 4; count -= 4, sum += 4, pixel += 4) {
        STORE(0)
        STORE(1)
        STORE(2)
        STORE(3)
    }
    for (; count > 0; count--, sum++, pixel++) {
        STORE(0)
    }
}

/* From a pixel of the bounds: of a row, and of all rows where they follow each other. */
static uint16_t *pixels_at(const qtri_surface *surface, const qtri_rect *bounds, int32_t y)
{
    return (uint16_t *)(void *)(surface->pixels + (y - surface->first_row) * surface->pitch) +
           bounds->x0;
}

static uint32_t sum_at(const qtri_surface *surface, const qtri_rect *bounds, int32_t y)
{
    return (uint32_t)(y - surface->first_row) * (uint32_t)surface->width + (uint32_t)bounds->x0;
}

enum qtri_error qtri_sum_add_565(uint32_t *sums, uint32_t words, const qtri_surface *surface)
{
    qtri_rect bounds;
    enum qtri_error error;
    if (begin(surface, sums, words, &bounds, &error)) {
        for (int32_t y = bounds.y0; y < bounds.y1; y++) {
            add_row(sums + sum_at(surface, &bounds, y), pixels_at(surface, &bounds, y),
                    bounds.x1 - bounds.x0);
        }
    }
    return error;
}

enum qtri_error qtri_sum_store_565(const qtri_surface *surface, const uint32_t *sums,
                                   uint32_t words, int32_t frames_log2)
{
    qtri_rect bounds;
    enum qtri_error error;
    const uint32_t log2 = (uint32_t)qtri_hold32(frames_log2, 0, QTRI_SUM_FRAMES_LOG2_MAX);
    if (begin(surface, sums, words, &bounds, &error)) {
        for (int32_t y = bounds.y0; y < bounds.y1; y++) {
            store_row(pixels_at(surface, &bounds, y), sums + sum_at(surface, &bounds, y),
                      bounds.x1 - bounds.x0, log2);
        }
    }
    return error;
}
