/* SPDX-License-Identifier: MIT */
/*
 * Makes pipelines: see pipeline.h. For C files; a C++ program, an Arduino sketch among them, keeps
 * its pipelines in a .c file beside it and declares them with QTRI_PIPELINE_DECLARE. What stands in
 * body/ is internal.
 */
#ifndef QTRI_PIPELINE_MAKE_H
#define QTRI_PIPELINE_MAKE_H

#include "body/large.h"
#include "body/pixel.h"
#include "body/small_samples.h"

#define QTRI_PIPELINE(name, ...)                                                                   \
    static void name##_large(struct qtri_large *triangle)                                          \
    {                                                                                              \
        static const qtri_options options = {__VA_ARGS__};                                         \
        qtri_large_triangle_draw(&options, triangle);                                              \
    }                                                                                              \
    static bool name##_small(struct qtri_small *triangle)                                          \
    {                                                                                              \
        static const qtri_options options = {__VA_ARGS__};                                         \
        return qtri_small_instance_draw(&options, triangle);                                       \
    }                                                                                              \
    const qtri_pipeline name = {{__VA_ARGS__}, name##_large, name##_small, NULL, NULL};

#define QTRI_PIPELINE_DECLARE(name) extern const qtri_pipeline name

#endif
