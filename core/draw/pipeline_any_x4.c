/* SPDX-License-Identifier: MIT */
/* The generic pipeline of surfaces with four samples a pixel, which formats name. */
#define QTRI_PIPELINE_IS_ANY
#define QTRI_PIPELINE_IS_ANY_X4
#include "qtri/pipeline_make.h"

#include "pipeline_x4.h"

static void large(const struct qtri_large_input *triangle)
{
    qtri_large_triangle_draw(&triangle->state->options, triangle);
}

static bool small(struct qtri_small *triangle)
{
    return qtri_small_instance_draw(&triangle->state->options, triangle);
}

const qtri_pipeline qtri_pipeline_any_x4 = {
    .options = {.format = QTRI_ANY, .samples = 4}, .large = large, .small = small};

const qtri_pipeline *const qtri_pipelines_x4[] = {&qtri_pipeline_any_x4, NULL};
