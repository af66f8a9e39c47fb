/* SPDX-License-Identifier: MIT */
/* Filters of textures, with pipelines for RGB565 with those that are used most. */
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

#define MIPMAPPED                                                                                  \
    .format = QTRI_RGB565, .depth = QTRI_LINEAR16, .compare = QTRI_LESS,                           \
    .texel = QTRI_TEXEL_RGB565, .mipmapped = 1

QTRI_PIPELINE(qtri_pipeline_mipmapped, MIPMAPPED)
QTRI_PIPELINE(qtri_pipeline_mipmapped_lit, MIPMAPPED, .shade = QTRI_LIGHT)
QTRI_PIPELINE(qtri_pipeline_mipmapped_white, MIPMAPPED, .shade = QTRI_WHITE_LIGHT)

static const qtri_pipeline *const by_level[] = {
    &qtri_pipeline_mipmapped, &qtri_pipeline_mipmapped_lit, &qtri_pipeline_mipmapped_white, NULL};

static const qtri_effect filtered = {between, qtri_filtered_loop};
static const qtri_effect mipmapped = {by_level, NULL};
static const qtri_effect filtered_levels = {NULL, qtri_filtered_loop};
const qtri_filter qtri_bilinear = {qtri_texel_between, QTRI_EFFECT(filtered), NULL};
const qtri_filter qtri_mipmapped = {NULL, QTRI_EFFECT(mipmapped), &qtri_levels};
const qtri_filter qtri_mipmapped_bilinear = {qtri_texel_between, QTRI_EFFECT(filtered_levels),
                                             &qtri_levels};
