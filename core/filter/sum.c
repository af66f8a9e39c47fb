/* SPDX-License-Identifier: MIT */
/*
 * Accumulation buffer: sums of frames, and their means. In any format a pixel has two words: red
 * and blue, 16 bits each, and green, all in the steps of the kind of colour. For 565 one is enough:
 * lanes of 10, 10 and 11 bits hold 32 times 31, 31 and 63.
 */
#include "qtri/antialias.h"
#include "qtri/error.h"

#include "../frame/pixel.h"
#include "mix.h"

/* Finds bounds, and the words of a pixel's sum; false: *error, or nothing to do. */
static bool find_bounds(const qtri_surface *surface, const uint32_t *sums, uint32_t words,
                        qtri_rect *bounds, uint32_t *pixel_words, enum qtri_error *error)
{
    QTRI_ASSERT(sums != NULL || words == 0);
    *bounds = qtri_surface_bounds(surface);
    *error = QTRI_OK;
    if (bounds->x0 >= bounds->x1) {
        return false;
    }
    *pixel_words = qtri_is_565(surface->format) ? 1 : 2;
    if (sums == NULL ||
        words / *pixel_words < (uint32_t)surface->width * (uint32_t)surface->rows) { /* <= 2^26 */
        *error = QTRI_ERROR_MEMORY;
    }
    return *error == QTRI_OK;
}

/* The index, among the surface's pixels, of the first pixel within bounds of row y. */
static uint32_t index_of(const qtri_surface *surface, const qtri_rect *bounds, int32_t y)
{
    return (uint32_t)(y - surface->first_row) * (uint32_t)surface->width + (uint32_t)bounds->x0;
}

/* ---- Rows ---- */

QTRI_NOINLINE static void add_row_565(uint32_t *sum, const uint16_t *pixel, int32_t count)
{
    uint32_t lanes = QTRI_LANES_565;
    QTRI_BODY_BARRIER(lanes);
    for (; count >= 4; count -= 4, sum += 4, pixel += 4) {
        QTRI_BODY_UNROLL
        for (int i = 0; i < 4; i++) {
            const uint32_t color = pixel[i];
            sum[i] += (color | color << 16) & lanes;
            QTRI_BODY_BARRIER(sum);
        }
    }
    for (; count > 0; count--) {
        *sum++ += qtri_lanes_565(*pixel++);
    }
}

static inline uint16_t mean_of(uint32_t sum, uint32_t half, uint32_t log2, uint32_t lanes)
{
    const uint32_t mean = ((sum + half) >> log2) & lanes;
    return (uint16_t)(mean | mean >> 16);
}

/* Stores the means of 2^log2 frames. */
QTRI_NOINLINE static void store_row_565(uint16_t *pixel, const uint32_t *sum, int32_t count,
                                        uint32_t log2)
{
    uint32_t lanes = QTRI_LANES_565;
    /* Half of a step in each lane. */
    const uint32_t half = log2 == 0 ? 0 : (uint32_t)0x00200801 << (log2 - 1);
    QTRI_BODY_BARRIER(lanes);
    for (; count >= 4; count -= 4, sum += 4, pixel += 4) {
        QTRI_BODY_UNROLL
        for (int i = 0; i < 4; i++) {
            pixel[i] = mean_of(sum[i], half, log2, lanes);
            QTRI_BODY_BARRIER(pixel);
        }
    }
    for (; count > 0; count--) {
        *pixel++ = mean_of(*sum++, half, log2, lanes);
    }
}

static void add_row_any(uint32_t *sum, const uint8_t *pixel, int32_t count,
                        const qtri_format *format)
{
    const qtri_masks *masks = qtri_masks_of(format->colors);
    for (; count > 0; count--, sum += 2, pixel += format->pixels->bytes) {
        const uint32_t color = qtri_color_of(format, format->pixels->load(pixel));
        sum[0] += (color >> masks->shift[0] & masks->mask[0]) << 16 |
                  (color >> masks->shift[2] & masks->mask[2]);
        sum[1] += color >> masks->shift[1] & masks->mask[1];
    }
}

static void store_row_any(uint8_t *pixel, const uint32_t *sum, int32_t count, uint32_t log2,
                          const qtri_format *format)
{
    const uint32_t half = (uint32_t)1 << log2 >> 1;
    const qtri_masks *masks = qtri_masks_of(format->colors);
    for (; count > 0; count--, sum += 2, pixel += format->pixels->bytes) {
        const uint32_t red = (sum[0] >> 16) + half;
        const uint32_t blue = (sum[0] & 0xFFFF) + half;
        const uint32_t green = sum[1] + half;
        const uint32_t stored =
            qtri_stored_of(format, (red >> log2 & masks->mask[0]) << masks->shift[0] |
                                       (green >> log2 & masks->mask[1]) << masks->shift[1] |
                                       (blue >> log2 & masks->mask[2]));
        format->pixels->store(pixel, &stored, 1, 1);
    }
}

/* ---- Frames ---- */

void qtri_sum_clear(uint32_t *sums, uint32_t words)
{
    QTRI_ASSERT(sums != NULL || words == 0);
    for (; words > 0; words--) {
        *sums++ = 0;
    }
}

enum qtri_error qtri_sum_add(uint32_t *sums, uint32_t words, const qtri_surface *surface)
{
    qtri_rect bounds;
    uint32_t pixel_words;
    enum qtri_error error;
    if (find_bounds(surface, sums, words, &bounds, &pixel_words, &error)) {
        const int32_t count = bounds.x1 - bounds.x0;
        for (int32_t y = bounds.y0; y < bounds.y1; y++) {
            uint32_t *sum = sums + pixel_words * index_of(surface, &bounds, y);
            uint8_t *pixels = qtri_surface_at(surface, bounds.x0, y);
            if (pixel_words == 1) {
                add_row_565(sum, (uint16_t *)(void *)pixels, count);
            } else {
                add_row_any(sum, pixels, count, surface->format);
            }
        }
    }
    return error;
}

enum qtri_error qtri_sum_store(const qtri_surface *surface, const uint32_t *sums, uint32_t words,
                               int32_t frames_log2)
{
    qtri_rect bounds;
    uint32_t pixel_words;
    enum qtri_error error;
    const uint32_t log2 = (uint32_t)qtri_hold32(frames_log2, 0, QTRI_SUM_FRAMES_LOG2_MAX);
    if (find_bounds(surface, sums, words, &bounds, &pixel_words, &error)) {
        const int32_t count = bounds.x1 - bounds.x0;
        for (int32_t y = bounds.y0; y < bounds.y1; y++) {
            const uint32_t *sum = sums + pixel_words * index_of(surface, &bounds, y);
            uint8_t *pixels = qtri_surface_at(surface, bounds.x0, y);
            if (pixel_words == 1) {
                store_row_565((uint16_t *)(void *)pixels, sum, count, log2);
            } else {
                store_row_any(pixels, sum, count, log2, surface->format);
            }
        }
    }
    return error;
}
