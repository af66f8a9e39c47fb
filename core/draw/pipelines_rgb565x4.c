/* SPDX-License-Identifier: MIT */
/* What most programs draw with on RGB565 with four samples a pixel: &qtri_rgb565_x4 names it. */
#include "qtri/pipeline_make.h"

#include "pipeline_x4.h"

#define LESS .format = QTRI_RGB565, .depth = QTRI_LINEAR16, .compare = QTRI_LESS, .samples = 4

QTRI_PIPELINE(qtri_pipeline_lit_x4, LESS, .shade = QTRI_LIGHT)
QTRI_PIPELINE(qtri_pipeline_texture_x4, LESS, .texel = QTRI_TEXEL_RGB565)
QTRI_PIPELINE(qtri_pipeline_texture_lit_x4, LESS, .texel = QTRI_TEXEL_RGB565, .shade = QTRI_LIGHT)
QTRI_PIPELINE(qtri_pipeline_texture_white_x4, LESS, .texel = QTRI_TEXEL_RGB565,
              .shade = QTRI_WHITE_LIGHT)

const qtri_pipeline *const qtri_pipelines_rgb565_x4[] = {
    &qtri_pipeline_lit_x4,           &qtri_pipeline_texture_x4, &qtri_pipeline_texture_lit_x4,
    &qtri_pipeline_texture_white_x4, &qtri_pipeline_any_x4,     NULL};
