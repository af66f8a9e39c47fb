/* SPDX-License-Identifier: MIT */
#include "draw_state.h"
#include "sampling.h"
#include "stroke_span.h"

#include "../bits/bits.h"

bool qtri_stroke_target_init(qtri_stroke_target *to, const qtri_surface *surface,
                             const qtri_material *material, uint8_t alpha, bool is_smooth)
{
    const bool is_covered = is_smooth || alpha != 255;
    to->alpha_q16 = ((uint32_t)alpha << 16) / 255;
    to->material = *material;
    to->material.texture = NULL;
    to->material.alphas = NULL;
    to->material.fragment = NULL;
    to->samples = qtri_sampling_of(surface->format) != NULL ? surface : NULL;
    if (to->samples != NULL) {
        to->pixel = *surface;
        to->pixel.format = qtri_sampling_of(surface->format)->format;
        surface = &to->pixel;
    }
    qtri_draw_state_init(&to->state, surface, qtri_stroke_pipelines, &to->material,
                         is_covered ? QTRI_FLAT | QTRI_COVERED : QTRI_FLAT);
    return to->state.bounds.x0 < to->state.bounds.x1;
}

void qtri_stroke_look_init(qtri_stroke_look *look, const qtri_stroke_end end[2])
{
    int32_t differ = 0;
    look->tints = NULL;
    qtri_stroke_look_set_depth(look, end[0].depth_16p8, end[1].depth_16p8);
    for (int i = 0; i < 3; i++) {
        const int32_t from = (end[0].color_8p16[i] + 128) >> 8; /* <= 65280 */
        look->color_8p8[i] = from;
        look->color_delta[i] = ((end[1].color_8p16[i] + 128) >> 8) - from;
        differ |= look->color_delta[i];
    }
    look->is_even = differ == 0;
    look->is_level = look->is_even && (look->z_low | (uint32_t)look->z_high) == 0;
}

/*
 * Four samples a pixel are as one: their mean takes what the stroke covers, and all become that.
 * Each pixel is drawn into memory of its own, in the column of four that a pattern asks for.
 */
QTRI_NOINLINE static void draw_samples(qtri_stroke_target *to, const qtri_stroke_span *all)
{
    const qtri_surface *samples = to->samples;
    const qtri_pixels *memory = samples->format->pixels;
    const qtri_pixels *plain = to->pixel.format->pixels;
    for (int32_t i = 0; i < all->count; i++) {
        uint32_t words[4];
        const int32_t x = all->is_upright ? all->x : all->x + i;
        const int32_t y = all->is_upright ? all->y + i : all->y;
        const ptrdiff_t row = y - samples->first_row;
        uint8_t *record = samples->pixels + row * samples->pitch + (ptrdiff_t)memory->bytes * x;
        uint8_t *at = (uint8_t *)words + (x & 3) * plain->bytes;
        const uint32_t before = memory->load(record);
        qtri_stroke_span one = *all;
        one.x = x & 3;
        one.y = y;
        one.count = 1;
        one.weight += i;
        one.share += i;
        to->pixel.pixels = (uint8_t *)words;
        to->pixel.pitch = 0;
        if (samples->depth != NULL) {
            to->pixel.depth = samples->depth + (x & ~3);
        }
        plain->store(at, &before, 1, 1);
        to->state.pipeline->span(&one);
        const uint32_t after = plain->load(at);
        if (after != before) {
            memory->store(record, &after, 1, 1);
        }
    }
}

void qtri_stroke_target_draw(qtri_stroke_target *to, const qtri_stroke_span *span)
{
    if (to->samples != NULL) {
        draw_samples(to, span);
    } else {
        to->state.pipeline->span(span);
    }
}
