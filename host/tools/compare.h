/* SPDX-License-Identifier: MIT */
/*
 * Comparing two pictures: colours, which triangle is visible, and depth.
 */
#ifndef QTRI_HOST_TOOLS_COMPARE_H
#define QTRI_HOST_TOOLS_COMPARE_H

#include <stdbool.h>
#include <stdint.h>

#include "../io/picture.h"

struct comparison {
    bool same_size; /* false: nothing below is meaningful but the sizes */
    int width[2], height[2];
    uint64_t pixels;

    /* Colours, all pixels. A pixel's error is the greatest of its three channels' differences. */
    uint64_t differing;              /* pixels whose error is not 0 */
    uint64_t pixels_with_error[256]; /* histogram of the errors */
    int max_color_error;             /* 0..255 */
    double mean_color_error;         /* of all channels of all pixels */
    double psnr;                     /* dB over all channels; INFINITY if equal */

    /* Where both pictures have ids. */
    bool has_id;
    uint64_t covered[2];          /* pixels with an id other than 0 */
    uint64_t coverage_mismatches; /* covered in one picture, background in the other */
    uint64_t other_triangle;      /* covered in both, by different triangles */

    /* Where both have depths: over the pixels that show the same triangle (or the background) in
       both, all pixels if there are no ids. In units of 1/65535. */
    bool has_depth;
    uint64_t depth_pixels;
    double max_depth_error;
    double mean_depth_error;
    double p999_depth_error; /* 99.9 % of these pixels have at most this difference */
};

void compare_pictures(const struct picture *a, const struct picture *b, struct comparison *out);

/*
 * A picture of the differences, for people:
 * - no difference: dark grey, 32 + luma / 8 of a, so that the objects can still be made out;
 * - a difference: each channel 64 + 16 times its difference, saturated at 255;
 * - covered in one picture only (where both have ids): pure red.
 * False if the sizes differ or memory runs out.
 */
bool compare_difference(const struct picture *a, const struct picture *b, struct picture *out);

/* How many pixels have a colour error above `max_color`. */
uint64_t compare_pixels_above(const struct comparison *comparison, int max_color);

#endif
