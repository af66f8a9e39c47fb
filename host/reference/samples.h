/* SPDX-License-Identifier: MIT */
/*
 * Pictures whose pixels are the mean of several places.
 *
 * `antialias msaa`: four samples on a rotated grid, each with a depth of its own; a triangle is
 * shaded once a pixel, at the centre, or where that is outside of it at the first sample inside.
 * `antialias ssaa`: two by two places, and `antialias temporal`: sixteen, each shaded where it is.
 * `edges` and `fxaa` have no such meaning: their reference looks at centres.
 */
#ifndef QTRI_HOST_REFERENCE_SAMPLES_H
#define QTRI_HOST_REFERENCE_SAMPLES_H

#include "target.h"

/* Replays the scene with each pixel looked at in one place. False when memory runs out. */
bool ref_render_at(const struct scene *scene, int subpixel_bits, const struct ref_sampling *at,
                   struct reference_image *image);

#endif
