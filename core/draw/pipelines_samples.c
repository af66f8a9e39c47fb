/* SPDX-License-Identifier: MIT */
/* Formats with four samples a pixel, and the pipelines for RGB565 that most programs need. */
#include "qtri/pipeline_make.h"

#include "../frame/pixel.h"
#include "../raster/samples.h"

#define LESS .format = QTRI_RGB565, .depth = QTRI_LINEAR16, .compare = QTRI_LESS, .samples = 4

QTRI_PIPELINE(qtri_pipeline_lit_x4, LESS, .shade = QTRI_LIGHT)
QTRI_PIPELINE(qtri_pipeline_texture_x4, LESS, .texel = QTRI_TEXEL_RGB565)
QTRI_PIPELINE(qtri_pipeline_texture_lit_x4, LESS, .texel = QTRI_TEXEL_RGB565, .shade = QTRI_LIGHT)
QTRI_PIPELINE(qtri_pipeline_texture_white_x4, LESS, .texel = QTRI_TEXEL_RGB565,
              .shade = QTRI_WHITE_LIGHT)

const qtri_pipeline *const qtri_pipelines_rgb565_x4[] = {
    &qtri_pipeline_lit_x4,           &qtri_pipeline_texture_x4, &qtri_pipeline_texture_lit_x4,
    &qtri_pipeline_texture_white_x4, &qtri_pipeline_any_x4,     NULL};

/* A format: that without samples, bytes of a record, kind of colours, its own encode, its pixel to
   0x00RRGGBB, and the pipelines beside those that a view names. */
#define FORMAT(name, SIZE, colors, encode, decoded, pipelines, number)                             \
    static uint32_t name##_load(const uint8_t *pixel)                                              \
    {                                                                                              \
        return qtri_samples_mean(&qtri_##name, pixel);                                             \
    }                                                                                              \
    static void name##_fill(uint8_t *pixel, uint32_t stored, uint32_t mask, int32_t count)         \
    {                                                                                              \
        qtri_samples_fill(pixel, stored, mask, count, SIZE);                                       \
    }                                                                                              \
    static void name##_store(uint8_t *pixel, const uint32_t *stored, uint32_t mask, int32_t count) \
    {                                                                                              \
        qtri_samples_store(pixel, stored, mask, count, SIZE);                                      \
    }                                                                                              \
    static uint32_t name##_decode(uint32_t stored)                                                 \
    {                                                                                              \
        return decoded(stored);                                                                    \
    }                                                                                              \
    static const qtri_pixels name##_records = {SIZE, name##_load, name##_fill, name##_store};      \
    static const qtri_sampling name##_samples = {&qtri_##name, pipelines};                         \
    const qtri_format qtri_##name##_x4 = {&name##_records, colors,          encode,                \
                                          name##_decode,   &name##_samples, number};

FORMAT(rgb565, QTRI_RGB565_X4_BYTES, &qtri_colors_565, NULL, qtri_decode_rgb565,
       qtri_pipelines_rgb565_x4, QTRI_RGB565)
FORMAT(rgb565_swapped, QTRI_RGB565_X4_BYTES, &qtri_colors_565, qtri_encode_rgb565_swapped,
       qtri_decode_rgb565_swapped, qtri_pipelines_x4, QTRI_RGB565_SWAPPED)
FORMAT(rgb888, QTRI_RGB888_X4_BYTES, &qtri_colors_888, qtri_encode_rgb888, qtri_decode_rgb888,
       qtri_pipelines_x4, QTRI_RGB888)
FORMAT(xrgb8888, QTRI_XRGB8888_X4_BYTES, &qtri_colors_888, NULL, qtri_decode_xrgb8888,
       qtri_pipelines_x4, QTRI_XRGB8888)
FORMAT(gray8, QTRI_GRAY8_X4_BYTES, &qtri_colors_gray, NULL, qtri_decode_gray8, qtri_pipelines_x4,
       QTRI_GRAY8)
