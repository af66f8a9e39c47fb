/* SPDX-License-Identifier: MIT */
/*
 * Sums of frames. In any format a pixel has two words: red and blue, 16 bits each, and green, all
 * in the steps of the kind of colour. For 565 one is enough: lanes of 10, 10 and 11 bits hold 32
 * times 31, 31 and 63.
 */
#include "qtri/filters.h"
#include "qtri/error.h"

#include "mix.h"

static uint32_t pixels_of(const qtri_surface *surface)
{
    return (uint32_t)surface->width *
           (uint32_t)surface->rows; /* <= 2^26 where bounds are not empty */
}

/* Whether there is something to do in the bounds, and memory for it: two words a pixel. */
static enum qtri_error check(const qtri_surface *surface, const qtri_rect *bounds,
                             const uint32_t *sums, uint32_t words)
{
    QTRI_ASSERT(sums != NULL || words == 0);
    const bool is_small = sums == NULL || words / 2 < pixels_of(surface);
    return bounds->x0 < bounds->x1 && is_small ? QTRI_ERROR_MEMORY : QTRI_OK;
}

static uint8_t *row_of(const qtri_surface *surface, int32_t y)
{
    return surface->pixels + (y - surface->first_row) * surface->pitch;
}

static uint32_t sum_at(const qtri_surface *surface, int32_t y)
{
    return (uint32_t)(y - surface->first_row) * (uint32_t)surface->width;
}

void qtri_sum_clear(uint32_t *sums, uint32_t words)
{
    QTRI_ASSERT(sums != NULL || words == 0);
    for (; words > 0; words--) {
        *sums++ = 0;
    }
}

enum qtri_error qtri_sum_add(uint32_t *sums, uint32_t words, const qtri_surface *surface)
{
    const qtri_rect bounds = qtri_surface_bounds(surface);
    const enum qtri_error error = check(surface, &bounds, sums, words);
    const qtri_format *format = surface->format;
    qtri_masks masks;
    if (error != QTRI_OK || bounds.x0 >= bounds.x1) {
        return error;
    }
    qtri_masks_of(&masks, format->colors);
    for (int32_t y = bounds.y0; y < bounds.y1; y++) {
        const uint8_t *row = row_of(surface, y);
        uint32_t *sum = sums + 2 * sum_at(surface, y);
        for (int32_t x = bounds.x0; x < bounds.x1; x++) {
            const uint32_t stored =
                format->pixels->load(row + x * (ptrdiff_t)format->pixels->bytes);
            const uint32_t color = qtri_color_of(format, stored);
            sum[2 * x] += (color >> masks.shift[0] & masks.mask[0]) << 16 |
                          (color >> masks.shift[2] & masks.mask[2]);
            sum[2 * x + 1] += color >> masks.shift[1] & masks.mask[1];
        }
    }
    return QTRI_OK;
}

enum qtri_error qtri_sum_store(const qtri_surface *surface, const uint32_t *sums, uint32_t words,
                               int32_t frames_log2)
{
    const qtri_rect bounds = qtri_surface_bounds(surface);
    const enum qtri_error error = check(surface, &bounds, sums, words);
    const qtri_format *format = surface->format;
    const int32_t log2 = qtri_hold32(frames_log2, 0, QTRI_SUM_FRAMES_LOG2_MAX);
    const uint32_t half = (uint32_t)1 << log2 >> 1;
    qtri_masks masks;
    if (error != QTRI_OK || bounds.x0 >= bounds.x1) {
        return error;
    }
    qtri_masks_of(&masks, format->colors);
    for (int32_t y = bounds.y0; y < bounds.y1; y++) {
        uint8_t *row = row_of(surface, y);
        const uint32_t *sum = sums + 2 * sum_at(surface, y);
        for (int32_t x = bounds.x0; x < bounds.x1; x++) {
            const uint32_t red = (sum[2 * x] >> 16) + half;
            const uint32_t blue = (sum[2 * x] & 0xFFFF) + half;
            const uint32_t green = sum[2 * x + 1] + half;
            const uint32_t stored =
                qtri_stored_of(format, (red >> log2 & masks.mask[0]) << masks.shift[0] |
                                           (green >> log2 & masks.mask[1]) << masks.shift[1] |
                                           (blue >> log2 & masks.mask[2]));
            format->pixels->store(row + x * (ptrdiff_t)format->pixels->bytes, &stored, 1, 1);
        }
    }
    return QTRI_OK;
}
