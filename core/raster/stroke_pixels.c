/* SPDX-License-Identifier: MIT */
/* Targets of strokes: the draw state, and pixels of four samples, drawn as one. */
#include "draw_state.h"
#include "samples.h"
#include "stroke_pixels.h"

#include "../bits/bits.h"

bool qtri_stroke_target_init(qtri_stroke_target *to, const qtri_surface *surface,
                             const qtri_material *material, const qtri_pipeline *const *pipelines,
                             uint8_t alpha, bool is_smooth)
{
    const bool is_covered = is_smooth || alpha != 255;
    to->alpha_q16 = ((uint32_t)alpha << 16) / 255;
    to->material = *material;
    to->material.alphas = NULL;
    to->material.fragment = NULL;
    to->samples = qtri_sampling_of(surface->format) != NULL ? surface : NULL;
    if (to->samples != NULL) {
        to->pixel = *surface;
        to->pixel.format = qtri_sampling_of(surface->format)->format;
        surface = &to->pixel;
    }
    qtri_draw_state_init(&to->state, surface, pipelines, &to->material, NULL,
                         is_covered ? QTRI_FLAT | QTRI_COVERED : QTRI_FLAT);
    return to->state.bounds.x0 < to->state.bounds.x1;
}

void qtri_stroke_look_init(qtri_stroke_look *look, const qtri_stroke_end end[2])
{
    int32_t differ = 0;
    look->light_table = NULL;
    qtri_stroke_look_set_depth(look, end[0].depth_16p8, end[1].depth_16p8);
    for (int i = 0; i < 3; i++) {
        const int32_t from = (end[0].color_8p16[i] + 128) >> 8; /* <= 65280 */
        look->color_8p8[i] = from;
        look->color_delta[i] = ((end[1].color_8p16[i] + 128) >> 8) - from;
        differ |= look->color_delta[i];
    }
    look->has_one_color = differ == 0;
    look->is_constant = look->has_one_color && (look->z_low | (uint32_t)look->z_high) == 0;
}

/*
 * A pixel of four samples is drawn as one: their mean goes to a pixel in memory, which the stroke
 * is drawn to, in the column of four that a pattern needs; all samples become the result.
 */
void qtri_stroke_sample_begin(qtri_stroke_sample *sample, qtri_stroke_target *to, int32_t x,
                              int32_t y)
{
    const qtri_surface *samples = to->samples;
    const qtri_pixels *memory = samples->format->pixels;
    const qtri_pixels *plain = to->pixel.format->pixels;
    const ptrdiff_t row = y - samples->first_row;
    sample->x = x & 3;
    sample->record = samples->pixels + row * samples->pitch + (ptrdiff_t)memory->bytes * x;
    sample->before = memory->load(sample->record);
    to->pixel.pixels = (uint8_t *)sample->words;
    to->pixel.pitch = 0;
    if (samples->depth != NULL) {
        to->pixel.depth = samples->depth + (x & ~3);
    }
    plain->store(to->pixel.pixels + sample->x * plain->bytes, &sample->before, 1, 1);
}

void qtri_stroke_sample_end(const qtri_stroke_sample *sample, const qtri_stroke_target *to)
{
    const qtri_pixels *plain = to->pixel.format->pixels;
    const uint32_t after = plain->load(to->pixel.pixels + sample->x * plain->bytes);
    if (after != sample->before) {
        to->samples->format->pixels->store(sample->record, &after, 1, 1);
    }
}

QTRI_NOINLINE static void draw_samples(qtri_stroke_target *to, const qtri_stroke_span *all)
{
    qtri_stroke_span one = *all;
    one.count = 1;
    one.rows = 1;
    for (; one.y < all->y + all->rows; one.y++) {
        for (int32_t x = all->x; x < all->x + all->count; x++, one.weight++, one.share++) {
            qtri_stroke_sample sample;
            qtri_stroke_sample_begin(&sample, to, x, one.y);
            one.x = sample.x;
            to->state.pipeline->span(&one);
            qtri_stroke_sample_end(&sample, to);
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
