/* SPDX-License-Identifier: MIT */
/*
 * The pipeline in double precision: what every picture of the fixed-point core is measured against.
 *
 * It replays the same scene with formulae, code and tables of its own; nothing is included from
 * core/. Two modes: with infinite sub-pixel precision it rasterizes in homogeneous coordinates
 * without clipping (Olano and Greer 1997); with vertices snapped to N sub-pixel bits it clips
 * (near, far, and a guard band only a reference can afford) and evaluates exact integer edge
 * functions, the ideal renderer of that precision.
 *
 * A scene that is anti-aliased with samples is looked at in the same places, see samples.h: colours
 * are their means, ids and depths those of pixel centres.
 */
#ifndef QTRI_HOST_REFERENCE_REFERENCE_H
#define QTRI_HOST_REFERENCE_REFERENCE_H

#include <stdbool.h>
#include <stdint.h>

#include "../io/scene.h"

/* What the reference knows of a pixel. Row 0 is the top. Colours are 0..255, not rounded. */
struct reference_image {
    int width, height;
    double *color;     /* 3 a pixel */
    double *color_min; /* 3 a pixel: least and greatest value each channel has at the three */
    double *color_max; /*   vertices of the visible triangle, before texturing; background: clear */
    double *depth;     /* window depth 0..1 */
    double *footprint; /* texels a pixel, of a texture that is mipmapped; else 0 */
    double *rounding; /* how many roundings may have added up: one where a pixel is stored, and what
                         is left of those of what it was mixed with */
    double *edge;     /* what smooth edges mixed, of 0..255: how far the greatest channel may be off
                         for an area that is off by a pixel */
    double *either; /* what decisions moved, of 0..255, that may fall otherwise: depths within 1 of
                       65535 of each other, a pixel's centre within 1/256 pixel of a hard edge or
                       between two parts of a stroke, a half of a pixel that is covered by 1/32 more
                       or less */
    double *other_depth; /* what is stored if the last of them falls otherwise; else depth */
    uint32_t *id;        /* 0 = background */
    uint32_t *hits;      /* how many triangles (or wireframe edges) covered the pixel, before the
                            depth test and the colour key, after culling and clipping */
};

/* subpixel_bits: 0 = infinite precision, 1..16 = snap. False when memory runs out. */
bool reference_render(const struct scene *scene, int subpixel_bits, struct reference_image *image);
void reference_free(struct reference_image *image);

#endif
