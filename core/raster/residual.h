/* SPDX-License-Identifier: MIT */
/*
 * Snap residuals: attributes through the places where vertices truly are. Internal.
 *
 * Pixels are covered by triangles whose vertices are snapped to 1/256 pixel, but an attribute
 * belongs to a vertex's true place, up to half a step away: on a floor that runs to the horizon
 * that is many texels. The plane through the true places is evaluated at the snapped ones, and
 * attributes are interpolated from there.
 *
 * With d1, d2 the true vertices 1 and 2 from vertex 0, and r_i the residual of vertex i,
 * r_i = b1_i d1 + b2_i d2, the plane of an attribute f is
 *
 *     f_i - b1_i (f_1 - f_0) - b2_i (f_2 - f_0)
 *
 * at snapped vertex i.
 */
#ifndef QTRI_RASTER_RESIDUAL_H
#define QTRI_RASTER_RESIDUAL_H

#include "gradient.h"
#include "large.h"

/* Weights are below 2^-6 and count 2^-36. */
#define QTRI_RESIDUAL_LOG2 36

typedef struct qtri_residual {
    bool is_on; /* false: attributes stay as they are */
    int32_t b1[3], b2[3];
} qtri_residual;

/*
 * It is off where no residual is known, where half a step of 1/256 pixel cannot be seen, and where
 * the triangle is so thin, a fifth of a pixel, that weights are large. In texels half a step can be
 * seen; depth and colours may be off by range extent / area, 1/4 of a step.
 */
void qtri_residual_init(qtri_residual *residual, const qtri_gradient *gradient,
                        const qtri_large_vertex v[3], bool textured, int32_t extent);

/* What is subtracted at vertex i, in units of f times 2^-up; up <= 16. */
int64_t qtri_residual_correction(const qtri_residual *residual, const uint32_t f[3], int i, int up);

/* f at the snapped vertices, clamped to min..max; true when one was outside. */
bool qtri_residual_apply(uint32_t f[3], const qtri_residual *residual, uint32_t min, uint32_t max);

#endif
