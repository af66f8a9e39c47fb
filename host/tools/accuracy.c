/* SPDX-License-Identifier: MIT */
#include "accuracy.h"

#include <math.h>
#include <stdlib.h>

double accuracy_per_100k(uint64_t count, uint64_t of)
{
    return of == 0 ? 0.0 : 1e5 * (double)count / (double)of;
}

static void add_color(struct accuracy *sum, const uint8_t rgb[3], const double color[3],
                      const double least[3], const double greatest[3], bool textured)
{
    int worst = 0;
    bool outside = false;
    for (int i = 0; i < 3; i++) {
        int error = abs(rgb[i] - (int)floor(color[i] + 0.5));
        worst = error > worst ? error : worst;
        /* The core takes 8-bit colours: half a step at the ends of the range is its rounding. */
        outside = outside || rgb[i] < floor(least[i] + 0.5) || rgb[i] > floor(greatest[i] + 0.5);
    }
    sum->color_above_1 += worst > 1;
    sum->color_range += outside && !textured;
    sum->max_color = worst > sum->max_color ? worst : sum->max_color;
}

/* What smooth edges mixed there: they may reach a pixel further in one picture. */
static double edge_near(const struct reference_image *reference, size_t i)
{
    const int width = reference->width;
    const int x = (int)(i % (size_t)width);
    const int y = (int)(i / (size_t)width);
    double most = 0;
    for (int row = y - 1; row <= y + 1; row++) {
        for (int column = x - 1; column <= x + 1; column++) {
            if (row >= 0 && row < reference->height && column >= 0 && column < width) {
                most = fmax(most, reference->edge[(size_t)row * (size_t)width + (size_t)column]);
            }
        }
    }
    return most;
}

/* What a channel is, for vertices on the grid and where they truly are: from least to greatest. */
static void color_range(double range[2], const struct reference_image *snapped,
                        const struct reference_image *unsnapped, size_t i, size_t c, int steps)
{
    const bool same = snapped->id[i] == unsnapped->id[i] && snapped->hits[i] == unsnapped->hits[i];
    const double first = snapped->color[3 * i + c] * steps / 255;
    const double second = same ? unsnapped->color[3 * i + c] * steps / 255 : first;
    range[0] = fmin(first, second);
    range[1] = fmax(first, second);
    for (int k = 0; k < 2 && steps == 255; k++) {
        range[k] = floor(range[k] + .5);
    }
}

/* How many times what its roundings, edges and decisions allow a pixel is off. */
static double mixed_error(const struct picture *picture, const struct reference_image *snapped,
                          const struct reference_image *unsnapped, size_t i, const int steps[3],
                          double step)
{
    const double moved = snapped->either[i] + edge_near(snapped, i) / 32;
    double worst = 0;
    for (size_t c = 0; c < 3; c++) {
        double range[2];
        color_range(range, snapped, unsnapped, i, c, steps[c]);
        const double got = floor(picture->rgb[3 * i + c] * steps[c] / 255.0 + .5);
        const double off = fmax(0, fmax(range[0] - got, got - range[1]));
        worst = fmax(worst, off / (step * snapped->rounding[i] + moved * steps[c] / 255));
    }
    return worst;
}

void accuracy_add_mixed(struct accuracy *sum, const struct picture *picture,
                        const struct reference_image *snapped,
                        const struct reference_image *unsnapped, const int steps[3], double step)
{
    const size_t pixels = (size_t)picture->width * (size_t)picture->height;
    for (size_t i = 0; i < pixels; i++) {
        if (picture->id[i] != snapped->id[i]) {
            continue;
        }
        const double error = mixed_error(picture, snapped, unsnapped, i, steps, step);
        sum->mixed++;
        sum->mixed_either += snapped->either[i] > step * 255 / steps[0] / 2;
        sum->mixed_above += error > 1;
        sum->max_mixed = fmax(sum->max_mixed, error);
    }
}

void accuracy_add(struct accuracy *sum, const struct picture *picture,
                  const struct reference_image *reference, bool textured)
{
    size_t pixels = (size_t)picture->width * (size_t)picture->height;
    for (size_t i = 0; i < pixels; i++) {
        uint32_t got = picture->id[i];
        uint32_t expected = reference->id[i];
        double depth_error = fabs(picture->depth[i] - reference->depth[i]) * 65535.0;
        sum->covered += expected != 0;
        if ((got != 0) != (expected != 0)) {
            sum->coverage++;
        } else if (got != expected) {
            sum->other_triangle += depth_error > 2.0;
        } else {
            sum->same++;
            add_color(sum, &picture->rgb[3 * i], &reference->color[3 * i],
                      &reference->color_min[3 * i], &reference->color_max[3 * i], textured);
            sum->depth_above_2 += depth_error > 2.0;
            sum->max_depth = depth_error > sum->max_depth ? depth_error : sum->max_depth;
        }
    }
}
