/* SPDX-License-Identifier: MIT */
/*
 * The three rasterizers of the reference. Pixel centres are at +0.5; a triangle covers the pixels
 * whose centre is inside it, and of those on its border the ones on top or left edges.
 */
#ifndef QTRI_HOST_REFERENCE_RASTER_H
#define QTRI_HOST_REFERENCE_RASTER_H

#include "target.h"

/* Infinite sub-pixel precision: homogeneous edge functions, no clipping. */
void ref_raster_homogeneous(struct ref_target *target, const struct ref_triangle *triangle);

/* Vertices snapped to the target's sub-pixel bits: clipping, then exact integer edge functions. */
void ref_raster_snapped(struct ref_target *target, const struct ref_triangle *triangle);

/* The outline of the triangle: three lines one pixel wide; snapped if the target is. */
void ref_raster_outline(struct ref_target *target, const struct ref_triangle *triangle);

/*
 * The facing of a triangle, before clipping: > 0 if it shows its front (counter-clockwise in the
 * picture), < 0 its back, 0 if it is seen edge-on. Defined for any w.
 */
int ref_facing(const struct ref_triangle *triangle);

/* Whether a triangle of this facing is to be drawn. */
bool ref_facing_is_drawn(const struct ref_target *target, int facing);

/* A pixel rectangle: low inclusive, high exclusive; empty if low >= high. */
struct ref_box {
    int x_low, y_low, x_high, y_high;
};

/* Floor of v, kept in 0..limit; a NaN gives 0. */
int ref_clamped_floor(long double v, int limit);

#endif
