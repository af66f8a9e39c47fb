/* SPDX-License-Identifier: MIT */
/*
 * Pipelines of the matrix: one for each set of options in which at most one axis is varied. A file
 * of them for each way to make colours, since they are slow to compile.
 */
#ifndef MATRIX_PIPELINES_H
#define MATRIX_PIPELINES_H

#include "qtri/pipeline_make.h"

#define MATRIX_LESS .depth = QTRI_LINEAR16, .compare = QTRI_LESS
#define MATRIX_BASE .format = QTRI_RGB565, MATRIX_LESS

/* Formats of surfaces, and tests. */
#define MATRIX_SURFACES(group, ...)                                                                \
    QTRI_PIPELINE(matrix_##group, MATRIX_BASE, __VA_ARGS__)                                        \
    QTRI_PIPELINE(matrix_##group##_swapped, .format = QTRI_RGB565_SWAPPED, MATRIX_LESS,            \
                  __VA_ARGS__)                                                                     \
    QTRI_PIPELINE(matrix_##group##_rgb888, .format = QTRI_RGB888, MATRIX_LESS, __VA_ARGS__)        \
    QTRI_PIPELINE(matrix_##group##_xrgb8888, .format = QTRI_XRGB8888, MATRIX_LESS, __VA_ARGS__)    \
    QTRI_PIPELINE(matrix_##group##_gray8, .format = QTRI_GRAY8, MATRIX_LESS, __VA_ARGS__)
#define MATRIX_TEST(group, name, test, ...)                                                        \
    QTRI_PIPELINE(matrix_##group##_##name, .format = QTRI_RGB565, .depth = QTRI_LINEAR16,          \
                  .compare = (test), __VA_ARGS__)
#define MATRIX_DEPTHS(group, ...)                                                                  \
    MATRIX_TEST(group, readonly, QTRI_LESS, .read_only = 1, __VA_ARGS__)                           \
    MATRIX_TEST(group, lequal, QTRI_LESS_EQUAL, __VA_ARGS__)                                       \
    MATRIX_TEST(group, greater, QTRI_GREATER, __VA_ARGS__)                                         \
    MATRIX_TEST(group, always, QTRI_ALWAYS, __VA_ARGS__)                                           \
    MATRIX_TEST(group, equal, QTRI_EQUAL, __VA_ARGS__)                                             \
    QTRI_PIPELINE(matrix_##group##_off, .format = QTRI_RGB565, __VA_ARGS__)
#define MATRIX_NAMED(group)                                                                        \
    &matrix_##group, &matrix_##group##_swapped, &matrix_##group##_rgb888,                          \
        &matrix_##group##_xrgb8888, &matrix_##group##_gray8, &matrix_##group##_readonly,           \
        &matrix_##group##_lequal, &matrix_##group##_greater, &matrix_##group##_always,             \
        &matrix_##group##_equal, &matrix_##group##_off

/* Formats of texels, a key, and both filters. */
#define MATRIX_TEXEL(group, name, kind, ...)                                                       \
    QTRI_PIPELINE(matrix_##group##_##name, MATRIX_BASE, .texel = (kind), __VA_ARGS__)
#define MATRIX_ALL_TEXELS(group, ...)                                                              \
    MATRIX_SURFACES(group, .texel = QTRI_TEXEL_RGB565, __VA_ARGS__)                                \
    MATRIX_DEPTHS(group, .texel = QTRI_TEXEL_RGB565, __VA_ARGS__)                                  \
    MATRIX_TEXEL(group, of_xrgb8888, QTRI_TEXEL_XRGB8888, __VA_ARGS__)                             \
    MATRIX_TEXEL(group, of_palette8, QTRI_TEXEL_PALETTE8, __VA_ARGS__)                             \
    MATRIX_TEXEL(group, of_gray8, QTRI_TEXEL_GRAY8, __VA_ARGS__)                                   \
    MATRIX_TEXEL(group, of_checker, QTRI_TEXEL_CHECKER, __VA_ARGS__)                               \
    MATRIX_TEXEL(group, key, QTRI_TEXEL_RGB565, .key = 1, __VA_ARGS__)                             \
    MATRIX_TEXEL(group, bilinear, QTRI_TEXEL_RGB565, .bilinear = 1, __VA_ARGS__)                   \
    MATRIX_TEXEL(group, bilinear_xrgb8888, QTRI_TEXEL_XRGB8888, .bilinear = 1, __VA_ARGS__)        \
    MATRIX_TEXEL(group, bilinear_palette8, QTRI_TEXEL_PALETTE8, .bilinear = 1, __VA_ARGS__)        \
    MATRIX_TEXEL(group, bilinear_gray8, QTRI_TEXEL_GRAY8, .bilinear = 1, __VA_ARGS__)              \
    MATRIX_TEXEL(group, bilinear_checker, QTRI_TEXEL_CHECKER, .bilinear = 1, __VA_ARGS__)          \
    const qtri_pipeline *const matrix_pipelines_##group[] = {MATRIX_NAMED(group),                  \
                                                             &matrix_##group##_of_xrgb8888,        \
                                                             &matrix_##group##_of_palette8,        \
                                                             &matrix_##group##_of_gray8,           \
                                                             &matrix_##group##_of_checker,         \
                                                             &matrix_##group##_key,                \
                                                             &matrix_##group##_bilinear,           \
                                                             &matrix_##group##_bilinear_xrgb8888,  \
                                                             &matrix_##group##_bilinear_palette8,  \
                                                             &matrix_##group##_bilinear_gray8,     \
                                                             &matrix_##group##_bilinear_checker,   \
                                                             NULL};

/* Without textures. */
#define MATRIX_PLAIN(group, ...)                                                                   \
    MATRIX_SURFACES(group, __VA_ARGS__)                                                            \
    MATRIX_DEPTHS(group, __VA_ARGS__)                                                              \
    const qtri_pipeline *const matrix_pipelines_##group[] = {MATRIX_NAMED(group), NULL};

/* Each ends with NULL. */
extern const qtri_pipeline *const matrix_pipelines_flat[],
    *const matrix_pipelines_lit[], *const matrix_pipelines_colors[],
                                       *const matrix_pipelines_texture[],
                                           *const matrix_pipelines_texture_lit[],
                                               *const matrix_pipelines_texture_colors[];

#endif
