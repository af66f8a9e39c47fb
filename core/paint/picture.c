/* SPDX-License-Identifier: MIT */
/* Images without rotation or scale: clipped, then copied, converted or blended. */
#include "picture.h"

#include "qtri/error.h"

#include "../frame/pixel.h"

bool qtri_picture_is_usable(const qtri_image *image)
{
    QTRI_ASSERT(image != NULL);
    return image->pixels != NULL && image->format != NULL && image->width >= 1 &&
           image->width <= QTRI_SURFACE_MAX && image->height >= 1 &&
           image->height <= QTRI_SURFACE_MAX;
}

bool qtri_picture_is_alike(const qtri_image *image, const qtri_surface *surface)
{
    const qtri_format *a = image->format;
    const qtri_format *b = surface->format;
    return a == b || (a->decode == b->decode && a->encode == b->encode && a->pixels == b->pixels);
}

bool qtri_picture_is_swapped(const qtri_image *image, const qtri_surface *surface)
{
    const qtri_mix from = qtri_mix_of(image->format), to = qtri_mix_of(surface->format);
    return (from == QTRI_MIX_565 && to == QTRI_MIX_565_SWAPPED) ||
           (from == QTRI_MIX_565_SWAPPED && to == QTRI_MIX_565);
}

/* The part of the surface that the picture at (x, y) covers, and its first pixel there; false:
   none. */
static bool clip_picture(const qtri_surface *surface, const qtri_image *image, int32_t x, int32_t y,
                         qtri_rect *rect, const uint8_t **first)
{
    const qtri_rect bounds = qtri_surface_bounds(surface);
    if (!qtri_picture_is_usable(image) || bounds.x0 == bounds.x1) {
        return false;
    }
    /* Positions beyond twice the largest frame are as far away as any. */
    const int32_t far_away = 2 * QTRI_SURFACE_MAX;
    x = qtri_hold32(x, -far_away, far_away);
    y = qtri_hold32(y, -far_away, far_away);
    rect->x0 = qtri_greatest32(bounds.x0, x);
    rect->y0 = qtri_greatest32(bounds.y0, y);
    rect->x1 = qtri_least32(bounds.x1, x + image->width);
    rect->y1 = qtri_least32(bounds.y1, y + image->height);
    *first = (const uint8_t *)image->pixels + (ptrdiff_t)(rect->y0 - y) * image->pitch +
             (ptrdiff_t)image->format->pixels->bytes * (rect->x0 - x);
    return rect->x0 < rect->x1 && rect->y0 < rect->y1;
}

uint32_t qtri_picture_key_mask(const qtri_image *image)
{
    return image->format->decode == qtri_decode_xrgb8888 ? 0x00FFFFFFu : UINT32_MAX;
}

/* Loads `count` stored pixels of a row from `at` on. */
static void load_pixels(const qtri_image *image, const uint8_t *at, uint32_t *stored, int32_t count)
{
    const qtri_pixels *pixels = image->format->pixels;
    if (pixels->bytes == 2) {
        const uint16_t *pixel = (const uint16_t *)(const void *)at;
        for (; count > 0; count--) {
            *stored++ = *pixel++;
        }
        return;
    }
    for (; count > 0; count--) {
        *stored++ = pixels->load(at);
        at += pixels->bytes;
    }
}

/* A bit for each pixel that is not the key's, the lowest for the last. */
static uint32_t mask_of(const qtri_image *image, const uint32_t *stored, int32_t count)
{
    uint32_t mask = UINT32_MAX >> (32 - count);
    if (image->has_key) {
        const uint32_t key_mask = qtri_picture_key_mask(image);
        const uint32_t key = image->key & key_mask;
        mask = 0;
        for (; count > 0; count--) {
            mask = mask << 1 | ((*stored++ & key_mask) != key);
        }
    }
    return mask;
}

/*
 * Decodes stored pixels to 0x00RRGGBB, or RGB565 only to its usual byte order if `keep_565`.
 * Frequent formats do without a call a pixel.
 */
static void decode(const qtri_image *image, bool keep_565, uint32_t *color, int32_t count)
{
    const qtri_mix kind = qtri_mix_of(image->format);
    const bool is_565 = kind == QTRI_MIX_565 || kind == QTRI_MIX_565_SWAPPED;
    uint32_t *end = color + count;
    if (kind == QTRI_MIX_565_SWAPPED) {
        for (uint32_t *c = color; c != end; c++) {
            *c = qtri_swap_16(*c);
        }
    }
    if (is_565 && !keep_565) {
        for (uint32_t *c = color; c != end; c++) {
            *c = qtri_pixel_565_to_888(*c);
        }
    } else if (kind == QTRI_MIX_32) {
        for (uint32_t *c = color; c != end; c++) {
            *c &= 0x00FFFFFFu;
        }
    } else if (!is_565) {
        for (uint32_t *c = color; c != end; c++) {
            *c = image->format->decode(*c);
        }
    }
}

/* Converts pixels from the image's format to the surface's, in place; room for a multiple of 4. */
static void convert(const qtri_image *image, const qtri_surface *surface, uint32_t *stored,
                    int32_t count)
{
    const qtri_format *format = surface->format;
    const qtri_mix kind = qtri_mix_of(image->format);
    const bool to_565 = format->colors == &qtri_colors_565;
    const bool keep_565 = to_565 && (kind == QTRI_MIX_565 || kind == QTRI_MIX_565_SWAPPED);
    decode(image, keep_565, stored, count);
    if (!keep_565) {
        qtri_mix_encode(format, stored, count);
    } else if (format->encode != NULL) {
        format->encode(stored, count);
    }
}

/* ---- Mixed pixels ---- */

QTRI_INLINE void mix_of(qtri_mix mix, uint32_t bytes, uint8_t *at, const uint32_t *stored,
                        uint32_t mask, uint32_t a)
{
    for (; mask != 0; mask <<= 1) {
        if ((int32_t)mask < 0) {
            const qtri_mix_part share = qtri_mix_part_of_stored(mix, *stored, a);
            qtri_save(bytes, at, qtri_mix_add(mix, qtri_load(bytes, at), 256 - a, share));
        }
        stored++;
        at += bytes;
    }
}

/* Blends `count` pixels of the surface with `stored`, which may change, a of 256. */
static void mix(const qtri_surface *surface, uint8_t *at, uint32_t *stored, uint32_t mask,
                int32_t count, uint32_t a)
{
    const qtri_format *format = surface->format;
    const uint32_t first = mask << (32 - count); /* the sign is the first pixel's */
    switch (qtri_mix_of(format)) {
        QTRI_MIX_CASES(mix_of, at, stored, first, a);
    default:
        for (int32_t i = 0; i < count; i++) {
            stored[i] = (format->decode(stored[i]) & 0x00FFFFFFu) | (a - 1) << 24;
        }
        qtri_mix_others(format, at, stored, mask, count);
        break;
    }
}

void qtri_picture_put(const qtri_surface *surface, const qtri_image *image, uint8_t *to,
                      uint32_t *stored, int32_t count, uint32_t a)
{
    const uint32_t mask = mask_of(image, stored, count);
    if (!qtri_picture_is_alike(image, surface)) {
        convert(image, surface, stored, count);
    }
    if (a == 256) {
        surface->format->pixels->store(to, stored, mask, count);
    } else {
        mix(surface, to, stored, mask, count, a);
    }
}

static void paint_row(const qtri_surface *surface, const qtri_image *image, uint8_t *to,
                      const uint8_t *from, int32_t count, uint32_t a)
{
    uint32_t stored[QTRI_PICTURE_BATCH];
    for (; count > 0; count -= QTRI_PICTURE_BATCH) {
        const int32_t n = qtri_least32(count, QTRI_PICTURE_BATCH);
        load_pixels(image, from, stored, n);
        qtri_picture_put(surface, image, to, stored, n, a);
        from += (ptrdiff_t)image->format->pixels->bytes * n;
        to += (ptrdiff_t)surface->format->pixels->bytes * n;
    }
}

/* ---- Draw calls ---- */

qtri_image qtri_image_of(const qtri_surface *surface)
{
    QTRI_ASSERT(surface != NULL);
    const qtri_image image = {
        surface->pixels, surface->pitch, surface->format, surface->width, surface->rows, false, 0};
    return image;
}

QTRI_INLINE void keyed_pixel(uint32_t bytes, uint8_t *to, const uint8_t *from, uint32_t key,
                             uint32_t mask, bool swaps)
{
    const uint32_t stored = qtri_load(bytes, from);
    if ((stored & mask) != key) {
        QTRI_BODY_BRANCH();
        qtri_save(bytes, to, swaps ? qtri_swap_16(stored) : stored);
    }
}

/* Pixels that are not the key, four at a time. */
QTRI_INLINE void keyed_row(uint32_t bytes, uint8_t *to, const uint8_t *from, int32_t count,
                           uint32_t key, uint32_t key_mask, bool swaps)
{
    const uint32_t mask = bytes == 4 ? key_mask : UINT32_MAX;
    for (; !QTRI_BODY_IS_SMALL && count >= 4; count -= 4) {
        QTRI_BODY_UNROLL
        for (uint32_t i = 0; i < 4 * bytes; i += bytes) {
            keyed_pixel(bytes, to + i, from + i, key, mask, swaps);
        }
        to += 4 * bytes;
        from += 4 * bytes;
        QTRI_BODY_BARRIER(to);
        QTRI_BODY_BARRIER(from);
    }
    for (; count > 0; count--, to += bytes, from += bytes) {
        keyed_pixel(bytes, to, from, key, mask, swaps);
    }
}

/* Stores pixels as they are, or with their bytes swapped, which are two: none is UINT32_MAX. */
static void paint_pixels(const qtri_surface *surface, const qtri_image *image, uint8_t *to,
                         const uint8_t *from, int32_t count, int32_t rows, bool swaps)
{
    const uint32_t mask = qtri_picture_key_mask(image);
    const uint32_t key = image->has_key ? image->key & mask : UINT32_MAX;
    for (; rows > 0; rows--, to += surface->pitch, from += image->pitch) {
        if (swaps) {
            keyed_row(2, to, from, count, key, mask, true);
            continue;
        }
        switch (image->format->pixels->bytes) {
            QTRI_BYTES_CASES(keyed_row, to, from, count, key, mask, false);
        }
    }
}

/* Rows of `bytes` each; pitches are bytes from a row to the next. */
static void copy_rows(uint8_t *to, ptrdiff_t to_pitch, const uint8_t *from, ptrdiff_t from_pitch,
                      size_t bytes, int32_t rows)
{
    for (; rows > 0; rows--) {
        qtri_copy(to, from, bytes);
        to += to_pitch;
        from += from_pitch;
    }
}

void qtri_image_paint(const qtri_surface *surface, const qtri_image *image, int32_t x, int32_t y)
{
    qtri_image_blend(surface, image, x, y, 255);
}

void qtri_image_blend(const qtri_surface *surface, const qtri_image *image, int32_t x, int32_t y,
                      uint8_t alpha)
{
    qtri_rect rect;
    const uint8_t *from;
    if (alpha == 0 || !clip_picture(surface, image, x, y, &rect, &from)) {
        return;
    }
    const bool is_alike = alpha == 255 && qtri_picture_is_alike(image, surface);
    const bool swaps = alpha == 255 && qtri_picture_is_swapped(image, surface);
    const int32_t count = rect.x1 - rect.x0;
    const int32_t rows = rect.y1 - rect.y0;
    uint8_t *to = qtri_surface_at(surface, rect.x0, rect.y0);
    if (swaps || (is_alike && image->has_key)) {
        paint_pixels(surface, image, to, from, count, rows, swaps);
    } else if (is_alike) {
        copy_rows(to, surface->pitch, from, image->pitch,
                  image->format->pixels->bytes * (size_t)count, rows);
    } else {
        for (int32_t row = 0; row < rows; row++, to += surface->pitch, from += image->pitch) {
            paint_row(surface, image, to, from, count, qtri_mix_weight(255, alpha));
        }
    }
}
