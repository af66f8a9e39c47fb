/* SPDX-License-Identifier: MIT */
#include "picture.h"

#include "../frame/barrier.h"

#ifdef __GNUC__
typedef uint32_t __attribute__((__may_alias__)) word;
#else
typedef uint32_t word;
#endif

qtri_image qtri_image_of(const qtri_surface *surface)
{
    const qtri_image image = {
        surface->pixels, surface->pitch, surface->format, surface->width, surface->rows, false, 0};
    return image;
}

/* Blocks of words. */
static size_t copy_words(uint8_t *to, const uint8_t *from, size_t bytes)
{
    word *out = (word *)(void *)to;
    const word *in = (const word *)(const void *)from;
    size_t left = bytes;
    for (; left >= 16; left -= 16) {
        const uint32_t a = in[0];
        const uint32_t b = in[1];
        const uint32_t c = in[2];
        const uint32_t d = in[3];
        out[0] = a;
        out[1] = b;
        out[2] = c;
        out[3] = d;
        out += 4;
        in += 4;
    }
    for (; left >= 4; left -= 4) {
        *out++ = *in++;
    }
    return bytes - left;
}

static size_t copy_halves(uint8_t *to, const uint8_t *from, size_t bytes)
{
    uint16_t *out = (uint16_t *)(void *)to;
    const uint16_t *in = (const uint16_t *)(const void *)from;
    size_t left = bytes;
    for (; left >= 8; left -= 8) {
        out[0] = in[0];
        QTRI_OPAQUE(out) /* or two would become a word that is not aligned */
        out[1] = in[1];
        QTRI_OPAQUE(out)
        out[2] = in[2];
        QTRI_OPAQUE(out)
        out[3] = in[3];
        out += 4;
        in += 4;
        QTRI_OPAQUE(out)
        QTRI_OPAQUE(in)
    }
    return bytes - left;
}

static size_t copy_bytes(uint8_t *to, const uint8_t *from, size_t bytes)
{
    size_t left = bytes;
    for (; left >= 4; left -= 4) {
        to[0] = from[0];
        to[1] = from[1];
        to[2] = from[2];
        to[3] = from[3];
        to += 4;
        from += 4;
    }
    return bytes - left;
}

/* As wide as both sides can be aligned at once. */
static void copy_row(uint8_t *to, const uint8_t *from, size_t bytes)
{
    const uintptr_t apart = (uintptr_t)to ^ (uintptr_t)from;
    const uintptr_t unit = (apart & 3) == 0 ? 4 : ((apart & 1) == 0 ? 2 : 1);
    for (; bytes > 0 && ((uintptr_t)to & (unit - 1)) != 0; bytes--) {
        *to++ = *from++;
    }
    const size_t done = unit == 4   ? copy_words(to, from, bytes)
                        : unit == 2 ? copy_halves(to, from, bytes)
                                    : copy_bytes(to, from, bytes);
    to += done;
    from += done;
    for (bytes -= done; bytes > 0; bytes--) {
        *to++ = *from++;
    }
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
    for (int32_t row = rect.y0; row < rect.y1; row++) {
        if (!is_alike) {
            paint_converted(surface, image, to, from, count);
        } else if (image->has_key) {
            paint_keyed(image, to, from, count);
        } else {
            copy_row(to, from, (size_t)bytes * (size_t)count);
        }
        to += surface->pitch;
        from += image->pitch;
    }
}
