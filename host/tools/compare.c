/* SPDX-License-Identifier: MIT */
/*
 * Measures of difference between two pictures. The command that prints them is compare_command.c.
 */
#include "compare.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static size_t pixel_count(const struct picture *picture)
{
    return (size_t)picture->width * (size_t)picture->height;
}

static void compare_colors(const struct picture *a, const struct picture *b, struct comparison *out)
{
    uint64_t sum = 0;
    uint64_t sum_of_squares = 0; /* <= 2^24 pixels * 3 * 255^2 < 2^42 */

    for (size_t i = 0; i < out->pixels; i++) {
        int error = 0;
        for (size_t c = 0; c < 3; c++) {
            int difference = abs(a->rgb[3 * i + c] - b->rgb[3 * i + c]);
            sum += (uint64_t)difference;
            sum_of_squares += (uint64_t)(difference * difference);
            error = difference > error ? difference : error;
        }
        out->pixels_with_error[error]++;
        if (error > out->max_color_error)
            out->max_color_error = error;
    }
    double channels = 3.0 * (double)out->pixels;
    out->differing = out->pixels - out->pixels_with_error[0];
    out->mean_color_error = (double)sum / channels;
    out->psnr = sum_of_squares == 0
                    ? (double)INFINITY
                    : 10.0 * log10(255.0 * 255.0 * channels / (double)sum_of_squares);
}

static void compare_ids(const struct picture *a, const struct picture *b, struct comparison *out)
{
    out->has_id = a->id && b->id;
    if (!out->has_id)
        return;
    for (size_t i = 0; i < out->pixels; i++) {
        bool in_a = a->id[i] != 0;
        bool in_b = b->id[i] != 0;
        out->covered[0] += in_a;
        out->covered[1] += in_b;
        out->coverage_mismatches += in_a != in_b;
        out->other_triangle += in_a && in_b && a->id[i] != b->id[i];
    }
}

/* False where the depths of pixel i belong to different surfaces and are not to be compared.
   A depth that is not a number (in a file from elsewhere) counts as an infinite difference. */
static bool depth_error(const struct picture *a, const struct picture *b, bool has_id, size_t i,
                        double *error)
{
    if (has_id && a->id[i] != b->id[i])
        return false;
    *error = fabs(a->depth[i] - b->depth[i]) * 65535.0;
    if (isnan(*error))
        *error = INFINITY;
    return true;
}

/*
 * The rank-th smallest depth error (rank 0 the least), in the memory of one histogram. The bits of
 * non-negative doubles order like the doubles, so the answer is found a byte at a time from the
 * top: a radix selection.
 */
static double depth_error_of_rank(const struct picture *a, const struct picture *b, bool has_id,
                                  size_t pixels, uint64_t rank)
{
    uint64_t prefix = 0; /* the bits found so far */
    double error;

    for (int shift = 56; shift >= 0; shift -= 8) {
        uint64_t count[256] = {0};
        uint64_t known = shift == 56 ? 0 : UINT64_MAX << (shift + 8);
        for (size_t i = 0; i < pixels; i++) {
            uint64_t bits;
            if (!depth_error(a, b, has_id, i, &error))
                continue;
            memcpy(&bits, &error, sizeof bits);
            if ((bits & known) == prefix)
                count[(bits >> shift) & 255]++;
        }
        uint64_t byte = 0;
        while (byte < 255 && rank >= count[byte])
            rank -= count[byte++];
        prefix |= byte << shift;
    }
    memcpy(&error, &prefix, sizeof error);
    return error;
}

static void compare_depths(const struct picture *a, const struct picture *b, struct comparison *out)
{
    double sum = 0.0;
    double error;

    out->has_depth = a->depth && b->depth;
    if (!out->has_depth)
        return;
    for (size_t i = 0; i < out->pixels; i++) {
        if (!depth_error(a, b, out->has_id, i, &error))
            continue;
        out->depth_pixels++;
        sum += error;
        out->max_depth_error = fmax(out->max_depth_error, error);
    }
    if (out->depth_pixels == 0)
        return;
    uint64_t above = out->depth_pixels / 1000; /* at most .1 % may lie above */
    out->mean_depth_error = sum / (double)out->depth_pixels;
    out->p999_depth_error =
        depth_error_of_rank(a, b, out->has_id, (size_t)out->pixels, out->depth_pixels - 1 - above);
}

void compare_pictures(const struct picture *a, const struct picture *b, struct comparison *out)
{
    *out = (struct comparison){
        .same_size = a->width == b->width && a->height == b->height,
        .width = {a->width, b->width},
        .height = {a->height, b->height},
    };
    if (!out->same_size)
        return;
    out->pixels = pixel_count(a);
    compare_colors(a, b, out);
    compare_ids(a, b, out);
    compare_depths(a, b, out);
}

uint64_t compare_pixels_above(const struct comparison *comparison, int max_color)
{
    uint64_t sum = 0;

    for (int error = max_color + 1; error < 256; error++)
        sum += comparison->pixels_with_error[error];
    return sum;
}

static void difference_pixel(const uint8_t *a, const uint8_t *b, uint8_t *out)
{
    int difference[3];
    int luma = (299 * a[0] + 587 * a[1] + 114 * a[2]) / 1000;
    bool same = true;

    for (int c = 0; c < 3; c++) {
        difference[c] = abs(a[c] - b[c]);
        same = same && difference[c] == 0;
    }
    for (int c = 0; c < 3; c++) {
        int bright = 64 + 16 * difference[c];
        out[c] = (uint8_t)(same ? 32 + luma / 8 : bright > 255 ? 255 : bright);
    }
}

bool compare_difference(const struct picture *a, const struct picture *b, struct picture *out)
{
    static const uint8_t red[3] = {255, 0, 0};

    if (a->width != b->width || a->height != b->height)
        return false;
    if (!picture_create(out, a->width, a->height, false))
        return false;
    for (size_t i = 0; i < pixel_count(a); i++) {
        bool mismatch = a->id && b->id && (a->id[i] != 0) != (b->id[i] != 0);
        if (mismatch)
            memcpy(&out->rgb[3 * i], red, 3);
        else
            difference_pixel(&a->rgb[3 * i], &b->rgb[3 * i], &out->rgb[3 * i]);
    }
    return true;
}
