/* SPDX-License-Identifier: MIT */
/* Filters of textures, with pipelines for RGB565 with the one between four texels. */
#include "qtri/pipeline_make.h"

#include "descriptions.h"

#define FILTERED                                                                                   \
    .format = QTRI_RGB565, .depth = QTRI_LINEAR16, .compare = QTRI_LESS, .read_only = QTRI_ANY,    \
    .texel = QTRI_TEXEL_RGB565, .bilinear = 1

QTRI_PIPELINE(qtri_pipeline_bilinear, FILTERED)
QTRI_PIPELINE(qtri_pipeline_bilinear_lit, FILTERED, .shade = QTRI_LIGHT)
QTRI_PIPELINE(qtri_pipeline_bilinear_white, FILTERED, .shade = QTRI_WHITE_LIGHT)

static const qtri_pipeline *const between[] = {&qtri_pipeline_bilinear, &qtri_pipeline_bilinear_lit,
                                               &qtri_pipeline_bilinear_white, NULL};

const qtri_filter qtri_bilinear = {true, false, QTRI_BROUGHT_LIST(between)};
const qtri_filter qtri_mipmapped = {false, true, NULL};
const qtri_filter qtri_mipmapped_bilinear = {true, true, NULL};
