#include "picture.h"

bool qtri_picture_is_usable(const qtri_image *image)
{
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

/* n / 255 for 0 <= n < 65535. */
#define DIVIDE_255(n) (((n) + 1 + ((n) >> 8)) >> 8)

/* To the nearest of 32 and 64 levels: no colour lies half-way between two. */
static uint32_t color_565(uint32_t c)
{
    const uint32_t red = DIVIDE_255((c >> 16 & 255) * 31 + 127);
    const uint32_t green = DIVIDE_255((c >> 8 & 255) * 63 + 127);
    const uint32_t blue = DIVIDE_255((c & 255) * 31 + 127);
    return red << 11 | green << 5 | blue;
}

/* .299 .587 .114 of 2^16, whose sum they are. */
static uint32_t color_gray(uint32_t c)
{
    return ((c >> 16 & 255) * 19595u + (c >> 8 & 255) * 38470u + (c & 255) * 7471u + 0x8000u) >> 16;
}

void qtri_picture_convert(const qtri_image *image, const qtri_surface *surface, uint32_t *stored,
                          int32_t count)
{
    uint32_t (*decode)(uint32_t) = image->format->decode;
    const qtri_format *format = surface->format;
    for (int32_t i = 0; i < count; i++) {
        const uint32_t color = decode(stored[i]);
        stored[i] = format->colors == &qtri_colors_565    ? color_565(color)
                    : format->colors == &qtri_colors_gray ? color_gray(color)
                                                          : color;
    }
    if (format->encode != NULL) {
        format->encode(stored, count);
    }
}
