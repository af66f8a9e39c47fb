/* SPDX-License-Identifier: MIT */
/* The generic pipeline: the body with options that are read for every pixel. */
#define QTRI_PIPELINE_IS_ANY
#include "qtri/pipeline_make.h"

QTRI_BODY_ALONE void pixel_at(qtri_pixel_walk *w, bool bent, uint8_t *pixel, uint8_t *depth)
{
    qtri_pixel_at(&w->state->options, w, bent, pixel, depth);
}

static void large(const struct qtri_large_input *triangle)
{
    qtri_large_triangle_draw(&triangle->state->options, pixel_at, triangle);
}

static bool small(struct qtri_small *triangle)
{
    return qtri_small_instance_draw(&triangle->state->options, pixel_at, triangle);
}

const qtri_pipeline qtri_pipeline_any = {
    .options = {.format = QTRI_ANY}, .large = large, .small = small};
