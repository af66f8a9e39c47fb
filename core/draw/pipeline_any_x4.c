/* SPDX-License-Identifier: MIT */
/* The generic pipeline for four samples a pixel; the formats with samples name it. */
#define QTRI_PIPELINE_IS_ANY
#define QTRI_PIPELINE_IS_ANY_BY_ASKS
#define QTRI_PIPELINE_IS_ANY_X4
#include "qtri/pipeline_make.h"

#include "../raster/draw_state.h"
#include "../raster/samples.h"

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

const qtri_pipeline qtri_pipeline_any_x4 = {.options = {.format = QTRI_ANY, .samples = 4},
                                            .large = large,
                                            .small = small,
                                            .choose = qtri_draw_state_ask};

const qtri_pipeline *const qtri_pipelines_x4[] = {&qtri_pipeline_any_x4, NULL};
