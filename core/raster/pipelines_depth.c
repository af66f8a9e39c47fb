/* SPDX-License-Identifier: MIT */
/* Formats of depth beside linear16, with pipelines for RGB565 with each. */
#include "qtri/pipeline_make.h"

#include "../frame/depth_format.h"
#include "descriptions.h"

#define ON(DEPTH)                                                                                  \
    .format = QTRI_RGB565, .depth = (DEPTH), .compare = QTRI_LESS, .read_only = QTRI_ANY
#define TEXTURE .texel = QTRI_TEXEL_RGB565

/* A list of them, and the pipelines. */
#define PIPELINES(list, DEPTH)                                                                     \
    QTRI_PIPELINE(list##_flat, ON(DEPTH))                                                          \
    QTRI_PIPELINE(list##_lit, ON(DEPTH), .shade = QTRI_LIGHT)                                      \
    QTRI_PIPELINE(list##_colors, ON(DEPTH), .shade = QTRI_COLORS)                                  \
    QTRI_PIPELINE(list##_texture, ON(DEPTH), TEXTURE)                                              \
    QTRI_PIPELINE(list##_texture_lit, ON(DEPTH), TEXTURE, .shade = QTRI_LIGHT)                     \
    QTRI_PIPELINE(list##_texture_white, ON(DEPTH), TEXTURE, .shade = QTRI_WHITE_LIGHT)             \
    static const qtri_pipeline *const list[] = {                                                   \
        &list##_flat,          &list##_lit, &list##_colors, &list##_texture, &list##_texture_lit,  \
        &list##_texture_white, NULL};

PIPELINES(qtri_on_float16, QTRI_FLOAT16)
PIPELINES(qtri_on_linear24, QTRI_LINEAR24)
PIPELINES(qtri_on_linear32, QTRI_LINEAR32)

const qtri_depth_format qtri_depth_float16 = {
    QTRI_DEPTH_FLOAT16_BYTES, &qtri_depth_words, qtri_depth_to_float16,
    qtri_depth_from_float16,  QTRI_FLOAT16,      QTRI_BROUGHT_LIST(qtri_on_float16)};
const qtri_depth_format qtri_depth_linear24 = {
    QTRI_DEPTH_LINEAR24_BYTES, &qtri_depth_words, qtri_depth_to_linear24,
    qtri_depth_from_linear24,  QTRI_LINEAR24,     QTRI_BROUGHT_LIST(qtri_on_linear24)};
const qtri_depth_format qtri_depth_linear32 = {
    QTRI_DEPTH_LINEAR32_BYTES, &qtri_depth_words, qtri_depth_as_it_is,
    qtri_depth_as_it_is,       QTRI_LINEAR32,     QTRI_BROUGHT_LIST(qtri_on_linear32)};
