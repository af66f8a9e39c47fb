/* SPDX-License-Identifier: MIT */
/* The textured ones of pipelines_rgb565.c of textures with levels, &qtri_mipmapped. */
#include "qtri/pipeline_make.h"

#define LESS                                                                                       \
    .format = QTRI_RGB565, .depth = QTRI_LINEAR16, .compare = QTRI_LESS,                           \
    .texel = QTRI_TEXEL_RGB565, .mipmapped = 1

QTRI_PIPELINE(qtri_pipeline_mipmapped, LESS)
QTRI_PIPELINE(qtri_pipeline_mipmapped_lit, LESS, .shade = QTRI_LIGHT)
QTRI_PIPELINE(qtri_pipeline_mipmapped_white, LESS, .shade = QTRI_WHITE_LIGHT)
