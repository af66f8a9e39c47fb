/* SPDX-License-Identifier: MIT */
/* Spans of strokes with options that are read for every pixel. */
#define QTRI_PIPELINE_IS_ANY
#include "stroke_span.h"

static void span(const qtri_stroke_span *span)
{
    qtri_stroke_span_draw(&span->state->options, span);
}

const qtri_pipeline qtri_stroke_any = {.options = {.format = QTRI_ANY}, .span = span};
