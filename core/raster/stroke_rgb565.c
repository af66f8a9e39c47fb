/* SPDX-License-Identifier: MIT */
/* Spans of smooth strokes on RGB565, with linear16 depth and "less"; and the list of all spans. */
#include "stroke_span.h"

static void draw_less(const qtri_stroke_span *span)
{
    static const qtri_options options = {
        .format = QTRI_RGB565, .depth = QTRI_LINEAR16, .compare = QTRI_LESS, .covered = 1};
    qtri_stroke_span_draw(&options, span);
}

static const qtri_pipeline less = {
    .options = {.format = QTRI_RGB565, .depth = QTRI_LINEAR16, .compare = QTRI_LESS, .covered = 1},
    .span = draw_less};

const qtri_pipeline *const qtri_stroke_pipelines[] = {&less, &qtri_stroke_any, NULL};
