/* SPDX-License-Identifier: MIT */
/* Surfaces in gray levels, ordered dithering, and error diffusion. */
#include "qtri/dither.h"
#include "qtri/error.h"

#include <stdbool.h>
#include <string.h>

/* White in 2^-24 of a gray level; sums of three are below 2^32 with the half that rounds. */
#define WEIGHT_8P24(thousandths, max)                                                              \
    ((uint32_t)((((uint64_t)255 * (thousandths) << 24) + (uint32_t)500 * (max)) /                  \
                ((uint32_t)1000 * (max))))

/* The weights' roundings move a sum by less than 2^-17 of a level: white is 255 in all formats. */
typedef struct weights {
    uint32_t r, g, b;
} weights;

static const weights weights_565 = {WEIGHT_8P24(299, 31), WEIGHT_8P24(587, 63),
                                    WEIGHT_8P24(114, 31)};
static const weights weights_888 = {WEIGHT_8P24(299, 255), WEIGHT_8P24(587, 255),
                                    WEIGHT_8P24(114, 255)};

static uint8_t luma(const weights *w, uint32_t r, uint32_t g, uint32_t b)
{
    return (uint8_t)((r * w->r + g * w->g + b * w->b + ((uint32_t)1 << 23)) >> 24);
}

static uint8_t luma_of_565(uint32_t c)
{
    return luma(&weights_565, (c >> 11) & 31, (c >> 5) & 63, c & 31);
}

/*
 * Gray levels of pixels within a row. A format is recognized by its `decode`, not by its address,
 * which would link all that belongs to it.
 */
static void gray_of_row(const qtri_format *format, const uint8_t *row, int32_t x, int32_t count,
                        uint8_t *gray)
{
    const qtri_pixels *pixels = format->pixels;
    if (format->decode == qtri_decode_gray8 && pixels->bytes == 1) {
        memcpy(gray, row + x, (size_t)count);
        return;
    }
    if (format->decode == qtri_decode_rgb565 && pixels->bytes == 2) {
        const uint16_t *stored = (const uint16_t *)(const void *)row + x;
        for (int32_t i = 0; i < count; i++) {
            gray[i] = luma_of_565(stored[i]);
        }
        return;
    }
    const uint8_t *at = row + (ptrdiff_t)pixels->bytes * x;
    const bool is_swapped = format->decode == qtri_decode_rgb565_swapped;
    const bool is_565 = is_swapped || format->decode == qtri_decode_rgb565;
    for (int32_t i = 0; i < count; i++, at += pixels->bytes) {
        uint32_t stored = pixels->load(at);
        if (is_565) {
            gray[i] = luma_of_565(is_swapped ? (stored & 255) << 8 | stored >> 8 : stored);
        } else {
            uint32_t c = format->decode(stored);
            gray[i] = luma(&weights_888, (c >> 16) & 255, (c >> 8) & 255, c & 255);
        }
    }
}

void qtri_surface_gray(const qtri_surface *surface, int32_t x, int32_t y, int32_t count,
                       uint8_t *gray)
{
    QTRI_ASSERT(surface != NULL);
    QTRI_ASSERT(gray != NULL || count <= 0);
    if (count <= 0) {
        return;
    }
    int64_t row = (int64_t)y - surface->first_row;
    int64_t end = (int64_t)x + count;
    int64_t from = x > 0 ? x : 0; /* the columns that there are: from..to-1 */
    int64_t to = end < surface->width ? end : surface->width;
    if (surface->format == NULL || row < 0 || row >= surface->rows || from >= to) {
        memset(gray, 0, (size_t)count);
        return;
    }
    memset(gray, 0, (size_t)(from - x));
    gray_of_row(surface->format, surface->pixels + (ptrdiff_t)row * surface->pitch, (int32_t)from,
                (int32_t)(to - from), gray + (from - x));
    memset(gray + (to - x), 0, (size_t)(end - to));
}

/*
 * Threshold k of N lies at (2k + 1) / 2N of a step, and level = floor(gray * max / 255 + that),
 * which is (gray * max + floor((2k + 1) 255 / 2N)) / 255, as the first term is whole. Offsets run
 * from 255 / 2N to 254: gray 0 stays below 255, and gray 255 below 255 (max + 1). The matrix of 2n
 * doubles that of n: 4 M(x mod n, y mod n) + 0 2 / 3 1 by the quarter; order 8 serves for order 4
 * as well, as M4(x, y) = M8(x, y) / 4 for x, y < 4.
 */
static const uint8_t bayer8[8][8] = {
    {0, 32, 8, 40, 2, 34, 10, 42},  {48, 16, 56, 24, 50, 18, 58, 26},
    {12, 44, 4, 36, 14, 46, 6, 38}, {60, 28, 52, 20, 62, 30, 54, 22},
    {3, 35, 11, 43, 1, 33, 9, 41},  {51, 19, 59, 27, 49, 17, 57, 25},
    {15, 47, 7, 39, 13, 45, 5, 37}, {63, 31, 55, 23, 61, 29, 53, 21},
};

/* A pixel's threshold in 128ths of a step; the middle where a level is to be the nearest. */
static uint32_t threshold_q7(qtri_dither dither, uint32_t x, uint32_t y)
{
    switch (dither) {
    case QTRI_DITHER_BAYER4:
        return bayer8[y & 3][x & 3] * 2u + 4;
    case QTRI_DITHER_BAYER8:
        return bayer8[y & 7][x & 7] * 2u + 1;
    default:
        return 64;
    }
}

/* n / 255 for 0 <= n < 65535. */
static uint32_t divide_by_255(uint32_t n)
{
    return (n + 1 + (n >> 8)) >> 8;
}

void qtri_dither_row(qtri_dither dither, uint8_t max_level, int32_t x, int32_t y,
                     const uint8_t *gray, int32_t count, uint8_t *level)
{
    QTRI_ASSERT((gray != NULL && level != NULL) || count <= 0);
    uint32_t offset[8];
    for (uint32_t i = 0; i < 8; i++) {
        offset[i] = threshold_q7(dither, i, (uint32_t)y) * 255 / 128;
    }
    for (int32_t i = 0; i < count; i++) { /* <= 255 * 255 + 254 */
        uint32_t n = (uint32_t)gray[i] * max_level + offset[((uint32_t)x + (uint32_t)i) & 7];
        level[i] = (uint8_t)divide_by_255(n);
    }
}

/*
 * A channel c becomes floor((c m + t) / 2^s), where c m / 2^s is c 31 / 255 or c 63 / 255 (249 and
 * 11, 253 and 10), and t is 2^(s-1) or so to nearest. A colour of RGB565, widened to 8 bits, lies
 * within -118..125 / 2048 and -120..123 / 1024 of its level: thresholds of 137..1901 and 123..879
 * keep it there.
 */
void qtri_dither_row_565(qtri_dither dither, int32_t x, int32_t y, const uint32_t *rgb,
                         int32_t count, uint16_t *pixels)
{
    QTRI_ASSERT((rgb != NULL && pixels != NULL) || count <= 0);
    const bool is_ordered = dither == QTRI_DITHER_BAYER4 || dither == QTRI_DITHER_BAYER8;
    uint16_t narrow[8], wide[8]; /* thresholds of green, of red and blue */
    for (uint32_t i = 0; i < 8; i++) {
        const uint32_t rank = threshold_q7(dither, i, (uint32_t)y) / 2; /* 0..63 */
        narrow[i] = (uint16_t)(is_ordered ? 123 + 12 * rank : 505);
        wide[i] = (uint16_t)(is_ordered ? 137 + 28 * rank : 1014);
    }
    for (int32_t i = 0; i < count; i++) { /* 255 * 249 + 1901 < 2^16: white stays 31 */
        const uint32_t c = rgb[i], at = ((uint32_t)x + (uint32_t)i) & 7;
        const uint32_t r = ((c >> 16 & 255) * 249 + wide[at]) >> 11;
        const uint32_t g = ((c >> 8 & 255) * 253 + narrow[at]) >> 10;
        const uint32_t b = ((c & 255) * 249 + wide[at]) >> 11;
        pixels[i] = (uint16_t)(r << 11 | g << 5 | b);
    }
}

enum qtri_error qtri_diffusion_init(qtri_diffusion *diffusion, int32_t width, int16_t *error,
                                    size_t count)
{
    QTRI_ASSERT(diffusion != NULL);
    QTRI_ASSERT(error != NULL || count == 0);
    if (width < 1 || width > QTRI_SURFACE_MAX) {
        return QTRI_ERROR_SIZE;
    }
    if (count < (size_t)width) {
        return QTRI_ERROR_MEMORY;
    }
    qtri_diffusion empty = {NULL, width, 0, 0, 0, 0, 0};
    *diffusion = empty;
    diffusion->error = error;
    return QTRI_OK;
}

/* A sixteenth of error, times weight, towards minus infinity; |error| <= 255, weight <= 7. */
static int32_t part_of_error(int32_t error, int32_t weight)
{
    return (error * weight + 4096) / 16 - 256;
}

/*
 * The error e of a pixel goes on in four parts that sum to e: 7/16 right, 3/16 below to the left,
 * 5/16 below, 1/16 (and what the others' roundings leave) below to the right. At the sides of the
 * picture they stay in its outermost columns, so the sum over the picture holds.
 *
 * error[x] is read, then free: it takes the next row's sum at x - 1's turn to be complete, which is
 * after x. `below` is that of x, `corner` the part of x + 1 so far.
 */
void qtri_diffuse_row(qtri_diffusion *diffusion, uint8_t max_level, int32_t x, int32_t y,
                      const uint8_t *gray, int32_t count, uint8_t *level)
{
    QTRI_ASSERT(diffusion != NULL);
    QTRI_ASSERT((gray != NULL && level != NULL) || count <= 0);
    qtri_diffusion *d = diffusion;
    if (x != d->next_x || y != d->next_y || (x == 0 && y == 0)) {
        for (int32_t i = 0; i < d->width; i++) {
            d->error[i] = 0;
        }
        d->right = d->below = d->corner = 0;
    }
    for (int32_t i = 0; i < count; i++) {
        int64_t column = (int64_t)x + i;
        if (column < 0 || column >= d->width) {
            continue;
        }
        int32_t value = (int32_t)gray[i] * max_level + d->error[column] + d->right;
        int32_t limit =
            (int32_t)255 * max_level; /* |value - limit / 2| < 2^16: errors are below 1024 */
        int32_t within = value < 0 ? 0 : (value > limit ? limit : value);
        uint32_t chosen = divide_by_255((uint32_t)within + 127);
        int32_t e = value - (int32_t)chosen * 255;
        e = e < -255 ? -255 : (e > 255 ? 255 : e);
        int32_t right = part_of_error(e, 7);
        int32_t left_below = part_of_error(e, 3);
        int32_t below = part_of_error(e, 5);
        if (column > 0) {
            d->error[column - 1] = (int16_t)(d->below + left_below);
        } else {
            below += left_below;
        }
        d->below = d->corner + below;
        d->corner = e - right - left_below - part_of_error(e, 5);
        d->right = right;
        if (column == d->width - 1) {
            d->error[column] = (int16_t)(d->below + d->corner + d->right);
            d->right = d->below = d->corner = 0;
        }
        level[i] = (uint8_t)chosen;
    }
    int64_t end = (int64_t)x + (count > 0 ? count : 0);
    bool complete = end >= d->width;
    d->next_x = complete ? 0 : (int32_t)end;
    d->next_y = complete && y < INT32_MAX ? y + 1 : y;
}
