/* SPDX-License-Identifier: MIT */
/*
 * Fragments of lit textured triangles, in light of one colour: nearest RGB565 texels, which become
 * RGB565 pixels. What fetch, qtri_tint_565 (or qtri_light_565, which is that with a tint of 1024)
 * and scatter make of them one after the other: without, S6 takes 3 % more on a Cortex-M0+ and 5 %
 * on an M3, S8 5 and 10 %.
 */
#include "fused.h"

#include "../frame/barrier.h"

/* c light tint: 63 2^10 2^10 < 2^26. */
#define TINTED(c, by) (((c)*light * (by) + half) >> 20)

void qtri_lit_list(const qtri_raster *raster, int32_t count)
{
    const uint32_t *number = raster->batch->color;
    const uint32_t *shade = raster->batch->by.shade;
    const uint32_t *place = raster->batch->place;
    const uint32_t *end = place + count;
    const uint16_t *texels = raster->texture->texels;
    uint8_t *pixels = raster->surface->pixels;
    const ptrdiff_t pitch = raster->surface->pitch;
    uint32_t r = raster->tint_q10[0];
    uint32_t g = raster->tint_q10[1];
    uint32_t b = raster->tint_q10[2];
    uint32_t half = (uint32_t)1 << 19;
    QTRI_OPAQUE(half)
    do {
        const uint32_t texel = texels[*number++];
        const uint32_t light = *shade++;
        uint32_t color = TINTED(texel >> 11, r) << 6;
        color |= TINTED(texel << 21 >> 26, g);
        color = color << 5 | TINTED(texel << 27 >> 27, b);
        uint16_t *const pixel = qtri_placed_16(pixels, pitch, *place++);
        *pixel = (uint16_t)color;
        QTRI_ASIDE(r)
        QTRI_ASIDE(g)
        QTRI_ASIDE(b)
    } while (place != end);
}
