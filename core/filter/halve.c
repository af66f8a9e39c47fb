/* SPDX-License-Identifier: MIT */
#include "qtri/antialias.h"

#include "mix.h"

/* Sets up the band of half the size, in the same memory; pixels are not changed yet. */
static enum qtri_error describe(const qtri_surface *band, qtri_surface *half)
{
    if (((band->width | band->height | band->first_row | band->rows) & 1) != 0) {
        return QTRI_ERROR_SIZE;
    }
    if (band->format == NULL) {
        return QTRI_ERROR_FORMAT;
    }
    const qtri_rect bounds = qtri_surface_bounds(band);
    *half = *band;
    half->depth = NULL;
    half->width = band->width / 2;
    half->height = band->height / 2;
    half->first_row = band->first_row / 2;
    half->rows = band->rows / 2;
    half->scissor.x0 = bounds.x0 / 2;
    half->scissor.y0 = bounds.y0 / 2;
    half->scissor.x1 = (bounds.x1 + 1) / 2;
    half->scissor.y1 = (bounds.y1 + 1) / 2;
    return QTRI_OK;
}

static void halve_any(const qtri_surface *band, const qtri_surface *half)
{
    const qtri_pixels *pixels = half->format->pixels;
    const ptrdiff_t bytes = pixels->bytes;
    for (int32_t y = half->scissor.y0; y < half->scissor.y1; y++) {
        const uint8_t *from = qtri_surface_at(band, 0, 2 * y);
        uint8_t *to = qtri_surface_at(half, 0, y);
        for (int32_t x = half->scissor.x0; x < half->scissor.x1; x++) {
            const uint8_t *at = from + 2 * x * bytes;
            const uint32_t stored[4] = {pixels->load(at), pixels->load(at + bytes),
                                        pixels->load(at + band->pitch),
                                        pixels->load(at + band->pitch + bytes)};
            const uint32_t mean = qtri_mean_of(half->format, stored);
            pixels->store(to + x * bytes, &mean, 1, 1);
        }
    }
}

/* Two rows of `count` words of two pixels into `count` pixels; most are of one colour. */
QTRI_NOINLINE static void halve_pairs(const qtri_word *upper, const qtri_word *lower, uint16_t *to,
                                      int32_t count)
{
    const uint16_t *const end = to + count;
    for (; to != end; to++) {
        const uint32_t a = *upper++;
        const uint32_t b = *lower++;
        uint32_t mean = a;
        if (a != b || a != (a << 16 | a >> 16)) {
            QTRI_BODY_BRANCH();
            mean = qtri_mean_565(qtri_low16(a), a >> 16, qtri_low16(b), b >> 16);
        }
        *to = (uint16_t)mean;
    }
}

static void halve_565(const qtri_surface *band, const qtri_surface *half)
{
    const qtri_rect *scissor = &half->scissor;
    for (int32_t y = scissor->y0; y < scissor->y1; y++) {
        const uint8_t *from = qtri_surface_at(band, 2 * scissor->x0, 2 * y);
        uint8_t *to = qtri_surface_at(half, scissor->x0, y);
        halve_pairs((const qtri_word *)(const void *)from,
                    (const qtri_word *)(const void *)(from + band->pitch), (uint16_t *)(void *)to,
                    scissor->x1 - scissor->x0);
    }
}

/* In place: row y is written when rows 2 y and 2 y + 1 have been read. */
enum qtri_error qtri_halve(const qtri_surface *band, qtri_surface *out)
{
    QTRI_ASSERT(band != NULL);
    QTRI_ASSERT(out != NULL);
    qtri_surface half;
    const enum qtri_error error = describe(band, &half);
    if (error != QTRI_OK) {
        return error;
    }
    if (qtri_is_565(half.format) && qtri_begins_with_words(band)) {
        halve_565(band, &half);
    } else {
        halve_any(band, &half);
    }
    *out = half;
    return QTRI_OK;
}
