/* SPDX-License-Identifier: MIT */
#include "picture.h"

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

bool qtri_picture_clip(const qtri_surface *surface, const qtri_image *image, int32_t x, int32_t y,
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

void qtri_picture_fetch(const qtri_image *image, const uint8_t *at, uint32_t *stored, int32_t count)
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

uint32_t qtri_picture_mask(const qtri_image *image, const uint32_t *stored, int32_t count)
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

/* As qtri_decode_rgb565. */
static inline uint32_t color_of_565(uint32_t c)
{
    return ((c >> 11) * 527 + 23) >> 6 << 16 | ((c >> 5 & 63) * 259 + 33) >> 6 << 8 |
           ((c & 31) * 527 + 23) >> 6;
}

/*
 * From stored pixels to 0x00RRGGBB; of those known to be RGB565 without their bytes' order if that
 * is all that is wanted. Frequent formats do not pay for a call a pixel.
 */
static void decode(const qtri_image *image, bool keep_565, uint32_t *color, int32_t count)
{
    const qtri_mix kind = qtri_mix_of(image->format);
    const bool is_565 = kind == QTRI_MIX_565 || kind == QTRI_MIX_565_SWAPPED;
    uint32_t *end = color + count;
    if (kind == QTRI_MIX_565_SWAPPED) {
        for (uint32_t *c = color; c != end; c++) {
            *c = qtri_swapped16(*c);
        }
    }
    if (is_565 && !keep_565) {
        for (uint32_t *c = color; c != end; c++) {
            *c = color_of_565(*c);
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

void qtri_picture_convert(const qtri_image *image, const qtri_surface *surface, uint32_t *stored,
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
