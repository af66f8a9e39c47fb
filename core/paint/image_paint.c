/* SPDX-License-Identifier: MIT */
#include "picture.h"

#include "qtri/error.h"

#include "../frame/barrier.h"

qtri_image qtri_image_of(const qtri_surface *surface)
{
    QTRI_ASSERT(surface != NULL);
    const qtri_image image = {
        surface->pixels, surface->pitch, surface->format, surface->width, surface->rows, false, 0};
    return image;
}

/* Pixels that are not the key, four at a time. */
QTRI_INLINE void keyed_row(int32_t bytes, uint8_t *to, const uint8_t *from, int32_t count,
                           uint32_t key, uint32_t mask)
{
#define ONE(i)                                                                                     \
    {                                                                                              \
        const uint32_t stored = qtri_stored_get(bytes, from + (i)*bytes);                          \
        if ((stored & mask) != key) {                                                              \
            QTRI_BRANCH                                                                            \
            qtri_stored_put(bytes, to + (i)*bytes, stored);                                        \
        }                                                                                          \
    }
#ifndef __OPTIMIZE_SIZE__
    for (; count >= 4; count -= 4) {
        ONE(0)
        ONE(1)
        ONE(2)
        ONE(3)
        to += 4 * bytes;
        from += 4 * bytes;
        QTRI_OPAQUE(to)
        QTRI_OPAQUE(from)
    }
#endif
    for (; count > 0; count--) {
        ONE(0)
        to += bytes;
        from += bytes;
    }
#undef ONE
}

static void paint_keyed(const qtri_image *image, uint8_t *to, const uint8_t *from, int32_t count)
{
    const uint32_t mask = qtri_picture_key_mask(image);
    const uint32_t key = image->key & mask;
    switch (image->format->pixels->bytes) {
    case 1:
        keyed_row(1, to, from, count, key, UINT32_MAX);
        break;
    case 2:
        keyed_row(2, to, from, count, key, UINT32_MAX);
        break;
    case 3:
        keyed_row(3, to, from, count, key, UINT32_MAX);
        break;
    default:
        keyed_row(4, to, from, count, key, mask);
        break;
    }
}

static void paint_converted(const qtri_surface *surface, const qtri_image *image, uint8_t *to,
                            const uint8_t *from, int32_t count)
{
    const qtri_pixels *pixels = surface->format->pixels;
    uint32_t stored[QTRI_PICTURE_BATCH];
    for (; count > 0; count -= QTRI_PICTURE_BATCH) {
        const int32_t n = qtri_least32(count, QTRI_PICTURE_BATCH);
        qtri_picture_fetch(image, from, stored, n);
        const uint32_t mask = qtri_picture_mask(image, stored, n);
        qtri_picture_convert(image, surface, stored, n);
        pixels->store(to, stored, mask, n);
        from += (ptrdiff_t)image->format->pixels->bytes * n;
        to += (ptrdiff_t)pixels->bytes * n;
    }
}

void qtri_image_paint(const qtri_surface *surface, const qtri_image *image, int32_t x, int32_t y)
{
    qtri_rect rect;
    const uint8_t *from;
    if (!qtri_picture_clip(surface, image, x, y, &rect, &from)) {
        return;
    }
    const int32_t bytes = surface->format->pixels->bytes;
    const bool is_alike = qtri_picture_is_alike(image, surface);
    const int32_t count = rect.x1 - rect.x0;
    uint8_t *to = qtri_surface_at(surface, rect.x0, rect.y0);
    if (is_alike && !image->has_key) {
        qtri_picture_copy(to, surface->pitch, from, image->pitch, (size_t)bytes * (size_t)count,
                          rect.y1 - rect.y0);
        return;
    }
    for (int32_t row = rect.y0; row < rect.y1; row++) {
        if (is_alike) {
            paint_keyed(image, to, from, count);
        } else {
            paint_converted(surface, image, to, from, count);
        }
        to += surface->pitch;
        from += image->pitch;
    }
}
