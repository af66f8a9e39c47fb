/* SPDX-License-Identifier: MIT */
/* Those of pipelines_rgb565.c in the byte order of displays on SPI. */
#include "qtri/pipeline_make.h"

#define LESS .format = QTRI_RGB565_SWAPPED, .depth = QTRI_LINEAR16, .compare = QTRI_LESS

QTRI_PIPELINE(qtri_pipeline_swapped_flat, LESS)
QTRI_PIPELINE(qtri_pipeline_swapped_lit, LESS, .shade = QTRI_LIGHT)
QTRI_PIPELINE(qtri_pipeline_swapped_colors, LESS, .shade = QTRI_COLORS)
QTRI_PIPELINE(qtri_pipeline_swapped_texture, LESS, .texel = QTRI_TEXEL_RGB565)
QTRI_PIPELINE(qtri_pipeline_swapped_texture_tint, LESS, .texel = QTRI_TEXEL_RGB565,
              .shade = QTRI_TINT)
QTRI_PIPELINE(qtri_pipeline_swapped_texture_lit, LESS, .texel = QTRI_TEXEL_RGB565,
              .shade = QTRI_LIGHT)
QTRI_PIPELINE(qtri_pipeline_swapped_texture_white, LESS, .texel = QTRI_TEXEL_RGB565,
              .shade = QTRI_WHITE_LIGHT)

const qtri_pipeline *const qtri_pipelines_swapped[] = {&qtri_pipeline_swapped_flat,
                                                       &qtri_pipeline_swapped_lit,
                                                       &qtri_pipeline_swapped_colors,
                                                       &qtri_pipeline_swapped_texture,
                                                       &qtri_pipeline_swapped_texture_tint,
                                                       &qtri_pipeline_swapped_texture_lit,
                                                       &qtri_pipeline_swapped_texture_white,
                                                       &qtri_pipeline_any,
                                                       NULL};
