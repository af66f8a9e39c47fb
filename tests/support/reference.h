/* SPDX-License-Identifier: MIT */
/*
 * What the tests of the double-precision reference share: rendering a scene written as text, and
 * pictures of coverage a reviewer can read.
 */
#ifndef QTRI_TESTS_REFERENCE_CHECK_H
#define QTRI_TESTS_REFERENCE_CHECK_H

#include <stdint.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "test.h"
#include "io/scene.h"
#include "reference/reference.h"

#define ARRAY_LENGTH(array) (sizeof(array) / sizeof((array)[0]))

/* The three ways to rasterize that tests repeat themselves for: infinite precision, the core's
   sub-pixel precision, and the finest. */
static const int all_bits[] = {0, 8, 16};

static inline void parse(const char *text, struct scene *scene)
{
    struct text_error error;

    if (!scene_parse("test", text, strlen(text), scene, &error))
        fail_msg("%s", error.message);
}

static inline struct reference_image render(const char *text, int subpixel_bits)
{
    struct scene scene;
    struct reference_image image;

    parse(text, &scene);
    assert_true(reference_render(&scene, subpixel_bits, &image));
    scene_free(&scene);
    return image;
}

static inline size_t at(const struct reference_image *image, int x, int y)
{
    return (size_t)y * (size_t)image->width + (size_t)x;
}

static inline int count_covered(const struct reference_image *image)
{
    int count = 0;

    for (int i = 0; i < image->width * image->height; i++)
        count += image->id[i] != 0;
    return count;
}

/* First and last covered pixel of a row must be these, with no gap between them. */
static inline void assert_row(const struct reference_image *image, int y, int first, int last)
{
    for (int x = 0; x < image->width; x++) {
        bool covered = image->id[at(image, x, y)] != 0;
        if (covered != (x >= first && x <= last))
            fail_msg("row %d: pixel %d is %s", y, x, covered ? "covered" : "not covered");
    }
}

static inline void assert_near(double value, double expected, double tolerance)
{
    if (!(fabs(value - expected) <= tolerance))
        fail_msg("%.12g is not within %g of %.12g", value, tolerance, expected);
}

/* The rows of the picture as text: '.' for background, the id's last digit otherwise. */
static inline void assert_ids(const struct reference_image *image, const char *const rows[])
{
    for (int y = 0; y < image->height; y++) {
        char row[256] = "";
        for (int x = 0; x < image->width; x++) {
            uint32_t id = image->id[at(image, x, y)];
            row[x] = id ? (char)('0' + id % 10) : '.';
        }
        assert_string_equal(row, rows[y]);
    }
}

/* splitmix32-like generator: the same numbers everywhere. */
static inline uint32_t next_random(uint32_t *state)
{
    uint32_t z = (*state += 0x9e3779b9u);

    z = (z ^ (z >> 16)) * 0x21f0aaadu;
    z = (z ^ (z >> 15)) * 0x735a2d97u;
    return z ^ (z >> 15);
}

/* Uniform in low..high. */
static inline double random_between(uint32_t *state, double low, double high)
{
    return low + (high - low) * (double)next_random(state) / 4294967295.0;
}

static inline int32_t q16(double v)
{
    return (int32_t)floor(v * 65536.0 + 0.5);
}

#endif
