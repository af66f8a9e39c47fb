/* SPDX-License-Identifier: MIT */
#include "accuracy.h"

#include <math.h>
#include <stdlib.h>

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
