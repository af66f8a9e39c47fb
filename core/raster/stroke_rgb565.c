/* SPDX-License-Identifier: MIT */
/* Spans of strokes on RGB565: smooth edges, with linear16 depth and "less", and without depth. */
#include "stroke_span.h"

#define SPANS(name, ...)                                                                           \
    static void name##_span(const qtri_stroke_span *span)                                          \
    {                                                                                              \
        static const qtri_options options = {__VA_ARGS__};                                         \
        qtri_stroke_span_draw(&options, span);                                                     \
    }                                                                                              \
    static const qtri_pipeline name = {.options = {__VA_ARGS__}, .span = name##_span};

SPANS(less, .format = QTRI_RGB565, .depth = QTRI_LINEAR16, .compare = QTRI_LESS, .covered = 1)

extern const qtri_pipeline qtri_stroke_any;

const qtri_pipeline *const qtri_stroke_pipelines[] = {&less, &qtri_stroke_any, NULL};
