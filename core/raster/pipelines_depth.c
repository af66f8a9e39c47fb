/* SPDX-License-Identifier: MIT */
/* Formats of depth beside linear16, with pipelines for RGB565 with each. */
#include "qtri/pipeline_make.h"

#include "../frame/depth_format.h"
#include "descriptions.h"

#define ON(DEPTH)                                                                                  \
    .format = QTRI_RGB565, .depth = (DEPTH), .compare = QTRI_LESS, .read_only = QTRI_ANY

QTRI_BROUGHT_PIPELINES(qtri_on_float16, ON(QTRI_FLOAT16))
QTRI_BROUGHT_PIPELINES(qtri_on_linear24, ON(QTRI_LINEAR24))
QTRI_BROUGHT_PIPELINES(qtri_on_linear32, ON(QTRI_LINEAR32))

/* A format that its pipelines and the generic pipeline's loop for RGB565 draw. */
#define DEPTH_FORMAT(name, BYTES, to, from, KIND)                                                  \
    static const qtri_effect on_##name = {qtri_on_##name, qtri_##name##_loop};                     \
    const qtri_depth_format qtri_depth_##name = {BYTES, &qtri_depth_words,     to, from,           \
                                                 KIND,  QTRI_EFFECT(on_##name)};

DEPTH_FORMAT(float16, QTRI_DEPTH_FLOAT16_BYTES, qtri_depth_to_float16, qtri_depth_from_float16,
             QTRI_FLOAT16)
DEPTH_FORMAT(linear24, QTRI_DEPTH_LINEAR24_BYTES, qtri_depth_to_linear24, qtri_depth_from_linear24,
             QTRI_LINEAR24)
DEPTH_FORMAT(linear32, QTRI_DEPTH_LINEAR32_BYTES, qtri_depth_as_it_is, qtri_depth_as_it_is,
             QTRI_LINEAR32)
