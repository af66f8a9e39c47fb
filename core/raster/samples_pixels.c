/* SPDX-License-Identifier: MIT */
/*
 * Surfaces of four samples a pixel: stores all samples of a pixel, clears, and resolves to means.
 */
#include <string.h>

#include "samples.h"

#include "../filter/mix.h"
#include "../frame/pixel.h"

/* `step`: 1, or 0 where all pixels get one colour. */
static void set_pixels(uint8_t *record, const uint32_t *stored, int32_t step, uint32_t mask,
                       int32_t count, int32_t size)
{
    const int32_t bytes = qtri_sample_bytes(size);
    for (; count > 0; count--, record += size, stored += step) {
        for (int k = 0; k < QTRI_SAMPLES && (mask >> (count - 1) & 1) != 0; k++) {
            qtri_sample_set_color(record, bytes, k, *stored);
        }
    }
}

void qtri_samples_fill(uint8_t *pixel, uint32_t stored, uint32_t mask, int32_t count, int32_t size)
{
    set_pixels(pixel, &stored, 0, mask, count, size);
}

void qtri_samples_store(uint8_t *pixel, const uint32_t *stored, uint32_t mask, int32_t count,
                        int32_t size)
{
    set_pixels(pixel, stored, 1, mask, count, size);
}

uint32_t qtri_samples_mean(const qtri_format *format, const uint8_t *record)
{
    const int32_t bytes = format->pixels->bytes;
    uint32_t stored[QTRI_SAMPLES];
    for (int k = 0; k < QTRI_SAMPLES; k++) {
        stored[k] = qtri_sample_color(record, bytes, k);
    }
    if (stored[0] == stored[1] && stored[0] == stored[2] && stored[0] == stored[3]) {
        return stored[0];
    }
    if (qtri_is_565(format)) {
        return qtri_mean_565(stored[0], stored[1], stored[2], stored[3]);
    }
    return qtri_mean_of(format, stored);
}

/* Clears records of any format, from `record` on. */
QTRI_INLINE void clear_any(uint8_t *record, int32_t count, uint32_t stored, int32_t bytes,
                           int32_t size)
{
    for (; count > 0; count--, record += size) {
        uint16_t *to = qtri_sample_depth(record, bytes, 1);
        for (int k = 0; k < QTRI_SAMPLES; k++) {
            qtri_sample_set_color(record, bytes, k, stored);
        }
        to[0] = UINT16_MAX;
        to[1] = UINT16_MAX;
        to[2] = UINT16_MAX;
    }
}

/*
 * Every other record of RGB565 begins with a word, and two of them are seven words, of colours and
 * depths: c c, c c, d d, d c, c c, c d, d d. Without words a lit mesh takes 30 % more time.
 */
enum { PAIR = 2 * QTRI_RGB565_X4_BYTES, PAIR_WORDS = PAIR / 4 };

static void clear_565(uint8_t *record, int32_t count, uint32_t stored)
{
    uint16_t half[2 * PAIR_WORDS];
    uint32_t two[PAIR_WORDS];
    clear_any((uint8_t *)half, 2, stored, QTRI_RGB565_BYTES, QTRI_RGB565_X4_BYTES);
    memcpy(two, half, sizeof two);
    if (((uintptr_t)record & 3) != 0) {
        clear_any(record, 1, stored, QTRI_RGB565_BYTES, QTRI_RGB565_X4_BYTES);
        record += QTRI_RGB565_X4_BYTES;
        count--;
    }
    const uint32_t colors = two[0], depths = two[2];
    const uint32_t depth_color = two[3], color_depth = two[5];
    for (; count >= 2; count -= 2, record += PAIR) {
        qtri_word *to = (qtri_word *)(void *)record;
        to[0] = colors;
        to[1] = colors;
        to[2] = depths;
        to[3] = depth_color;
        to[4] = colors;
        to[5] = color_depth;
        to[6] = depths;
    }
    clear_any(record, count, stored, QTRI_RGB565_BYTES, QTRI_RGB565_X4_BYTES);
}

/* A surface without pixels that has the depths of sample 0. */
static qtri_surface first_depths(const qtri_surface *surface)
{
    qtri_surface plain = *surface;
    plain.format = &qtri_depth_only;
    return plain;
}

void qtri_samples_clear(const qtri_surface *surface, qtri_rgb color)
{
    QTRI_ASSERT(surface != NULL);
    if (qtri_sampling_of(surface->format) == NULL) {
        qtri_surface_clear(surface, color);
        return;
    }
    const qtri_surface plain = first_depths(surface);
    qtri_surface_clear(&plain, color);
    const qtri_rect bounds = qtri_surface_bounds(surface);
    const uint32_t stored = qtri_pixel_from_rgb(surface->format, color);
    const int32_t size = surface->format->pixels->bytes;
    for (int32_t y = bounds.y0; y < bounds.y1; y++) {
        uint8_t *record = qtri_surface_at(surface, 0, y) + (ptrdiff_t)bounds.x0 * size;
        if (size == QTRI_RGB565_X4_BYTES) {
            clear_565(record, bounds.x1 - bounds.x0, stored);
        } else {
            clear_any(record, bounds.x1 - bounds.x0, stored, qtri_sample_bytes(size), size);
        }
    }
}

void qtri_samples_clear_depth(const qtri_surface *surface, q16 depth)
{
    QTRI_ASSERT(surface != NULL);
    if (qtri_sampling_of(surface->format) == NULL) {
        qtri_surface_clear_depth(surface, depth);
        return;
    }
    const qtri_surface plain = first_depths(surface);
    qtri_surface_clear_depth(&plain, depth);
    const qtri_rect bounds = qtri_surface_bounds(surface);
    const uint32_t depth_16p16 = 65535u * (uint32_t)qtri_hold32(depth, 0, Q16_ONE);
    const uint16_t stored = (uint16_t)((depth_16p16 + 0x8000) >> 16);
    const int32_t size = surface->format->pixels->bytes;
    for (int32_t y = bounds.y0; y < bounds.y1; y++) {
        uint8_t *record = qtri_surface_at(surface, 0, y) + (ptrdiff_t)bounds.x0 * size;
        for (int32_t x = bounds.x0; x < bounds.x1; x++, record += size) {
            for (int k = 1; k < QTRI_SAMPLES; k++) {
                *qtri_sample_depth(record, qtri_sample_bytes(size), k) = stored;
            }
        }
    }
}

/* Records to pixels. */
static void resolve_565(const uint8_t *record, uint16_t *to, int32_t count)
{
    const uint16_t *color = (const uint16_t *)(const void *)record;
    for (const uint16_t *end = to + count; to != end; color += QTRI_RGB565_X4_BYTES / 2) {
        const uint32_t a = color[0], b = color[1], c = color[2], d = color[3];
        uint32_t mean = a;
        if (a != b || a != c || a != d) {
            QTRI_BODY_BRANCH();
            mean = qtri_mean_565(a, b, c, d);
        }
        *to++ = (uint16_t)mean;
    }
}

/* In place: the pixels of a row are written over its records, from the row's start on. */
enum qtri_error qtri_samples_resolve(const qtri_surface *samples, qtri_surface *out)
{
    QTRI_ASSERT(samples != NULL);
    QTRI_ASSERT(out != NULL);
    const struct qtri_sampling *sampling = qtri_sampling_of(samples->format);
    if (sampling == NULL) {
        return QTRI_ERROR_FORMAT;
    }
    const qtri_surface from = *samples;
    const qtri_format *format = sampling->format;
    const qtri_rect bounds = qtri_surface_bounds(&from);
    const int32_t size = from.format->pixels->bytes, bytes = format->pixels->bytes;
    *out = from;
    out->format = format;
    out->depth = NULL;
    for (int32_t y = bounds.y0; y < bounds.y1; y++) {
        uint8_t *row = qtri_surface_at(&from, 0, y);
        if (qtri_is_565(format)) {
            resolve_565(row + (ptrdiff_t)bounds.x0 * size, (uint16_t *)(void *)row + bounds.x0,
                        bounds.x1 - bounds.x0);
            continue;
        }
        for (int32_t x = bounds.x0; x < bounds.x1; x++) {
            const uint32_t mean = qtri_samples_mean(format, row + (ptrdiff_t)x * size);
            qtri_sample_set_color(row + (ptrdiff_t)x * bytes, bytes, 0, mean);
        }
    }
    return QTRI_OK;
}
