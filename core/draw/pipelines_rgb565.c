/* SPDX-License-Identifier: MIT */
/* Pipelines for RGB565 that most programs need, and a view's default list of pipelines. */
#include "qtri/pipeline_make.h"

#define LESS .format = QTRI_RGB565, .depth = QTRI_LINEAR16, .compare = QTRI_LESS

QTRI_PIPELINES_USUAL(qtri_pipeline, LESS)
QTRI_PIPELINE(qtri_pipeline_texture_tint, LESS, .texel = QTRI_TEXEL_RGB565, .shade = QTRI_TINT)

const qtri_pipeline *const qtri_pipelines_default[] = {
    &qtri_pipeline_flat,          &qtri_pipeline_lit,
    &qtri_pipeline_colors,        &qtri_pipeline_texture,
    &qtri_pipeline_texture_tint,  &qtri_pipeline_texture_lit,
    &qtri_pipeline_texture_white, &qtri_pipeline_brought,
    &qtri_pipeline_any,           NULL};

void qtri_view_init(qtri_view *view, int32_t frame_width, int32_t frame_height)
{
    qtri_view_init_pipelines(view, frame_width, frame_height, qtri_pipelines_default);
}

/* Pipelines for the byte order of displays on SPI. */
QTRI_PIPELINES(qtri_pipelines_swapped, qtri_pipeline_swapped, .format = QTRI_RGB565_SWAPPED,
               .depth = QTRI_LINEAR16, .compare = QTRI_LESS)
