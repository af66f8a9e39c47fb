/* SPDX-License-Identifier: MIT */
/* Spans of strokes with options that are read for every pixel. */
#define QTRI_PIPELINE_IS_ANY
#include "stroke_span.h"

static void span(const qtri_stroke_span *span)
{
    qtri_options o = span->state->options;
    o.texel = QTRI_NO_TEXEL; /* constants, for the compiler to leave out what they need */
    o.shade = QTRI_FLAT;
    o.fragment = NULL;
    o.vertex_alpha = o.bilinear = o.key = o.alpha_test = o.large_texture = 0;
    qtri_stroke_span_draw(&o, span);
}

const qtri_pipeline qtri_stroke_any = {.options = {.format = QTRI_ANY}, .span = span};
