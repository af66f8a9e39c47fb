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

/* The pipeline `name` with these options, fields of qtri_options: QTRI_PIPELINE(mine, .format =
 * QTRI_RGB565). */
#define QTRI_PIPELINE(name, ...)                                                                   \
    QTRI_BODY void name##_pixel(qtri_pixel_walk *w, bool bent, uint8_t *pixel, uint8_t *depth)     \
    {                                                                                              \
        static const qtri_options options = {__VA_ARGS__};                                         \
        qtri_pixel_at(&options, w, bent, pixel, depth);                                            \
    }                                                                                              \
    static void name##_large(const struct qtri_large_input *triangle)                              \
    {                                                                                              \
        static const qtri_options options = {__VA_ARGS__};                                         \
        qtri_large_triangle_draw(&options, name##_pixel, triangle);                                \
    }                                                                                              \
    static bool name##_small(struct qtri_small *triangle)                                          \
    {                                                                                              \
        static const qtri_options options = {__VA_ARGS__};                                         \
        return qtri_small_instance_draw(&options, name##_pixel, triangle);                         \
    }                                                                                              \
    const qtri_pipeline name = {{__VA_ARGS__}, name##_large, name##_small, NULL, NULL, NULL};

/* Pipelines of further options for what most draw: `name`_flat, _lit, _colors, and of RGB565 texels
   _texture, _texture_lit and _texture_white. */
#define QTRI_PIPELINES_USUAL(name, ...)                                                            \
    QTRI_PIPELINE(name##_flat, __VA_ARGS__)                                                        \
    QTRI_PIPELINE(name##_lit, __VA_ARGS__, .shade = QTRI_LIGHT)                                    \
    QTRI_PIPELINE(name##_colors, __VA_ARGS__, .shade = QTRI_COLORS)                                \
    QTRI_PIPELINE(name##_texture, __VA_ARGS__, .texel = QTRI_TEXEL_RGB565)                         \
    QTRI_PIPELINE(name##_texture_lit, __VA_ARGS__, .texel = QTRI_TEXEL_RGB565,                     \
                  .shade = QTRI_LIGHT)                                                             \
    QTRI_PIPELINE(name##_texture_white, __VA_ARGS__, .texel = QTRI_TEXEL_RGB565,                   \
                  .shade = QTRI_WHITE_LIGHT)

/*
 * QTRI_PIPELINES_USUAL and `name`_texture_tint, and `list` of them, which ends with the generic
 * pipeline. So everything is drawn fast on another format, or with another comparison:
 *
 *     QTRI_PIPELINES(on_gray, on_gray_with, .format = QTRI_GRAY8, .depth = QTRI_LINEAR16,
 *                    .compare = QTRI_LESS_EQUAL)
 */
#define QTRI_PIPELINES(list, name, ...)                                                            \
    QTRI_PIPELINES_USUAL(name, __VA_ARGS__)                                                        \
    QTRI_PIPELINE(name##_texture_tint, __VA_ARGS__, .texel = QTRI_TEXEL_RGB565,                    \
                  .shade = QTRI_TINT)                                                              \
    const qtri_pipeline *const list[] = {                                                          \
        &name##_flat,          &name##_lit,          &name##_colors,                               \
        &name##_texture,       &name##_texture_tint, &name##_texture_lit,                          \
        &name##_texture_white, &qtri_pipeline_any,   NULL};

/* Declares a pipeline that another file makes. */
#define QTRI_PIPELINE_DECLARE(name) extern const qtri_pipeline name

#endif
