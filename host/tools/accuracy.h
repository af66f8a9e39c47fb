/* SPDX-License-Identifier: MIT */
/*
 * How far a picture of the fixed-point core is from the double-precision reference.
 */
#ifndef QTRI_HOST_TOOLS_ACCURACY_H
#define QTRI_HOST_TOOLS_ACCURACY_H

#include <stdint.h>

#include "../io/picture.h"
#include "../reference/reference.h"

/* Counts of pixels unless said otherwise; they add up over pictures. */
struct accuracy {
    uint64_t covered;        /* by the reference */
    uint64_t coverage;       /* covered in one picture and not in the other */
    uint64_t other_triangle; /* show another triangle, the depths apart by more than 2 / 65535 */
    uint64_t same;           /* show the same triangle, or nothing, in both: what follows */
    uint64_t color_above_1;  /* a channel off by more than 1 of 255 */
    uint64_t color_range;    /* untextured, a channel outside the range of the vertices' */
    uint64_t depth_above_2;  /* depth off by more than 2 of 65535 */
    int max_color;           /* largest error of a channel, 0..255 */
    double max_depth;        /* in 1/65535 */
};

/* Adds the comparison of an RGB888 picture with dumps to *sum. `textured`: skip color_range. */
void accuracy_add(struct accuracy *sum, const struct picture *picture,
                  const struct reference_image *reference, bool textured);

#endif
