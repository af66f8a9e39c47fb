/* SPDX-License-Identifier: MIT */
#include "../frame/depth_format.h"
#include "effect.h"

#include "../frame/pixel.h"

/*
 * What fog and a blend are asked with: colours of 8 bits a channel, that are mixed with stored
 * pixels as 8 bits a channel, so that what is covered of them is rounded once, at the end.
 */
static void set_raster(qtri_raster *raster, qtri_format *wide, const qtri_surface *surface,
                       const qtri_material *material)
{
    *wide = *surface->format;
    wide->colors = &qtri_colors_888;
    wide->encode = NULL;
    raster->surface = surface;
    raster->format = wide;
    raster->wide = true;
    raster->finer = false;
    raster->of.planes = NULL;
    raster->alpha = material->alpha;
    raster->keep = material->keep;
    raster->blend = material->blend;
    raster->fog = material->fog != NULL && material->fog->stages != NULL ? material->fog : NULL;
}

/* A colour, or what a share of it, 0..2^16, makes of a stored pixel, before it is encoded. */
static uint32_t word_of(const qtri_format *format, const int32_t color_8p16[3],
                        const uint8_t *pixel, int32_t share_q16)
{
    int32_t color[3] = {color_8p16[0], color_8p16[1], color_8p16[2]};
    if (share_q16 < 65536) {
        const uint32_t stored = format->decode(format->pixels->load(pixel));
        for (int i = 0; i < 3; i++) {
            const int32_t below = (int32_t)(stored >> (16 - 8 * i) & 0xFFu) << 16;
            /* |.| <= 255 2^7 2^16 < 2^31 */
            color[i] = below + ((((color[i] - below) >> 9) * share_q16) >> 7);
        }
    }
    const qtri_channels channels = qtri_channels_from_color(format->colors, color);
    return format->colors->pack(channels.c);
}

/* Fog, one by one: their depths are of no common plane. */
static void apply_fog(const qtri_raster *raster, qtri_covered *pixels)
{
    for (int32_t i = 0; i < pixels->count; i++) {
        uint32_t color[4] = {pixels->color[i], 0, 0, 0};
        const qtri_ramp depth = {pixels->depth[i], 0, 0};
        const qtri_fragments at = {NULL, 0, &depth, NULL};
        raster->fog->stages->apply(raster, color, &at, 1);
        pixels->color[i] = color[0];
    }
}

/* In linear16 the half that rounds it is in a depth already. */
static void write_depth(const qtri_surface *surface, uint32_t place, uint32_t depth)
{
    const qtri_depth_testing *testing = qtri_depth_testing_of(surface);
    if (testing != NULL) {
        (void)testing->passes(surface, QTRI_ALWAYS, place, (depth & ~1u) - 0x8000u, true);
        return;
    }
    surface->depth[(ptrdiff_t)(place >> 16) * surface->depth_pitch + (ptrdiff_t)(place & 0xFFFF)] =
        (uint16_t)(depth >> 16);
}

void qtri_stroke_effects(const qtri_surface *surface, const qtri_material *material,
                         qtri_covered *pixels)
{
    const qtri_format *format = surface->format;
    const int32_t all = pixels->count;
    uint32_t mask = qtri_mask_of(all);
    qtri_raster raster;
    qtri_format wide;
    set_raster(&raster, &wide, surface, material);
    if (raster.fog != NULL) {
        apply_fog(&raster, pixels);
    }
    if (raster.blend != NULL) {
        const qtri_fragments at = {pixels->place, pixels->place[0], NULL, NULL};
        for (int32_t i = 0; i < all; i++) {
            pixels->color[i] |= 0xFF000000u;
        }
        mask = raster.blend->apply(&raster, pixels->color, &at, mask, all);
    }
    pixels->count = 0;
    for (int32_t i = 0; i < all; i++) {
        if ((mask >> (all - 1 - i) & 1) == 0) {
            continue;
        }
        const uint32_t color = pixels->color[i];
        const uint32_t place = pixels->place[i];
        const int32_t color_8p16[3] = {(int32_t)(color & 0xFF0000), (int32_t)(color & 0xFF00) << 8,
                                       (int32_t)(color & 0xFF) << 16};
        const uint8_t *pixel = surface->pixels + (ptrdiff_t)(place >> 16) * surface->pitch +
                               (ptrdiff_t)((place & 0xFFFF) * format->pixels->bytes);
        const int32_t n = pixels->count++;
        pixels->color[n] = word_of(format, color_8p16, pixel, pixels->share_q16[i]);
        pixels->place[n] = place;
        if ((pixels->depth[i] & 1) != 0) {
            write_depth(surface, place, pixels->depth[i]);
        }
    }
    if (pixels->count != 0) {
        if (format->encode != NULL) {
            format->encode(pixels->color, pixels->count);
        }
        format->pixels->scatter(surface->pixels, surface->pitch, pixels->place, pixels->color,
                                pixels->count);
    }
}
