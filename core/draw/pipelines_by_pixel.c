/* SPDX-License-Identifier: MIT */
/*
 * What most programs draw with in light by pixel on RGB565: linked where &qtri_per_pixel is named,
 * and taken before a view's generic pipeline, which would take three times as long.
 */
#include "per_pixel.h"
#include "qtri/pipeline_make.h"

#define BY_PIXEL                                                                                   \
    .format = QTRI_RGB565, .depth = QTRI_LINEAR16, .compare = QTRI_LESS, .shade = QTRI_COLORS,     \
    .per_pixel = 1

QTRI_PIPELINE(qtri_pipeline_by_pixel, BY_PIXEL)
QTRI_PIPELINE(qtri_pipeline_texture_by_pixel, BY_PIXEL, .texel = QTRI_TEXEL_RGB565)

const qtri_pipeline *const qtri_pipelines_by_pixel[] = {&qtri_pipeline_by_pixel,
                                                        &qtri_pipeline_texture_by_pixel, NULL};
