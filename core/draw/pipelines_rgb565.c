/* SPDX-License-Identifier: MIT */
/* What most programs draw with on RGB565. */
#include "qtri/pipeline_make.h"

#define LESS .format = QTRI_RGB565, .depth = QTRI_LINEAR16, .compare = QTRI_LESS

QTRI_PIPELINE(qtri_pipeline_flat, LESS)
QTRI_PIPELINE(qtri_pipeline_lit, LESS, .shade = QTRI_LIGHT)
QTRI_PIPELINE(qtri_pipeline_colors, LESS, .shade = QTRI_COLORS)
QTRI_PIPELINE(qtri_pipeline_texture, LESS, .texel = QTRI_TEXEL_RGB565)
QTRI_PIPELINE(qtri_pipeline_texture_tint, LESS, .texel = QTRI_TEXEL_RGB565, .shade = QTRI_TINT)
QTRI_PIPELINE(qtri_pipeline_texture_lit, LESS, .texel = QTRI_TEXEL_RGB565, .shade = QTRI_LIGHT)
QTRI_PIPELINE(qtri_pipeline_texture_white, LESS, .texel = QTRI_TEXEL_RGB565,
              .shade = QTRI_WHITE_LIGHT)
