/* SPDX-License-Identifier: MIT */
/* RGB565 in fog. */
#include "qtri/pipeline_make.h"

#include "descriptions.h"

#define LESS                                                                                       \
    .format = QTRI_RGB565, .depth = QTRI_LINEAR16, .compare = QTRI_LESS, .read_only = QTRI_ANY
#define FOG     LESS, .fog = 1
#define TEXTURE .texel = QTRI_TEXEL_RGB565

QTRI_PIPELINE(qtri_pipeline_fog, FOG)
QTRI_PIPELINE(qtri_pipeline_fog_lit, FOG, .shade = QTRI_LIGHT)
QTRI_PIPELINE(qtri_pipeline_fog_colors, FOG, .shade = QTRI_COLORS)
QTRI_PIPELINE(qtri_pipeline_fog_texture, FOG, TEXTURE)
QTRI_PIPELINE(qtri_pipeline_fog_texture_lit, FOG, TEXTURE, .shade = QTRI_LIGHT)
QTRI_PIPELINE(qtri_pipeline_fog_texture_white, FOG, TEXTURE, .shade = QTRI_WHITE_LIGHT)

const qtri_pipeline *const qtri_pipelines_fog[] = {&qtri_pipeline_fog,
                                                   &qtri_pipeline_fog_lit,
                                                   &qtri_pipeline_fog_colors,
                                                   &qtri_pipeline_fog_texture,
                                                   &qtri_pipeline_fog_texture_lit,
                                                   &qtri_pipeline_fog_texture_white,
                                                   NULL};
