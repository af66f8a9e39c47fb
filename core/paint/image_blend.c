/* SPDX-License-Identifier: MIT */
#include "picture.h"

static void blend_row(const qtri_surface *surface, const qtri_image *image, uint8_t *to,
                      const uint8_t *from, int32_t count, uint32_t a)
{
    const bool is_alike = qtri_picture_is_alike(image, surface);
    uint32_t stored[QTRI_PICTURE_BATCH];
    for (; count > 0; count -= QTRI_PICTURE_BATCH) {
        const int32_t n = qtri_least32(count, QTRI_PICTURE_BATCH);
        qtri_picture_fetch(image, from, stored, n);
        const uint32_t mask = qtri_picture_mask(image, stored, n);
        if (!is_alike) {
            qtri_picture_convert(image, surface, stored, n);
        }
        qtri_picture_mix(surface, to, stored, mask, n, a);
        from += (ptrdiff_t)image->format->pixels->bytes * n;
        to += (ptrdiff_t)surface->format->pixels->bytes * n;
    }
}

void qtri_image_blend(const qtri_surface *surface, const qtri_image *image, int32_t x, int32_t y,
                      uint8_t alpha)
{
    qtri_rect rect;
    const uint8_t *from;
    if (alpha == 255) {
        qtri_image_paint(surface, image, x, y);
        return;
    }
    if (alpha == 0 || !qtri_picture_clip(surface, image, x, y, &rect, &from)) {
        return;
    }
    uint8_t *to = qtri_surface_at(surface, rect.x0, rect.y0);
    for (int32_t row = rect.y0; row < rect.y1; row++) {
        blend_row(surface, image, to, from, rect.x1 - rect.x0, qtri_mix_weight(255, alpha));
        to += surface->pitch;
        from += image->pitch;
    }
}
