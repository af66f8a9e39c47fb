/* SPDX-License-Identifier: MIT */
/*
 * Attributes of large triangles through the places where the vertices truly are. Internal.
 *
 * Pixels are covered by triangles whose vertices are snapped to 1/256 pixel, and attributes are
 * interpolated between those. But the attribute that a vertex has belongs to its true place, up to
 * half a step away: on a floor that runs to the horizon that is many texels. So the plane through
 * the true places is looked at where the snapped ones are, and attributes are interpolated from
 * there: what is covered stays between the three, and all that follows is as it was.
 *
 * With d1, d2 the true vertices 1 and 2 from vertex 0, and r_i by how much true place i is off the
 * snapped one, r_i = b1_i d1 + b2_i d2: the plane of an attribute f has
 *
 *     f_i - b1_i (f_1 - f_0) - b2_i (f_2 - f_0)
 *
 * at snapped vertex i. The six weights are the triangle's, and small.
 */
#ifndef QTRI_RASTER_UNSNAPPED_H
#define QTRI_RASTER_UNSNAPPED_H

#include "triangle.h"

/* Weights are below 2^-6 and count 2^-36. */
#define QTRI_UNSNAPPED_LOG2 36

typedef struct qtri_unsnapped {
    bool is_on; /* false: attributes stay as they are */
    int32_t b1[3], b2[3];
} qtri_unsnapped;

/*
 * Whether half a step of 1/256 pixel can be seen: in texels it can. Others are off by
 * range extent / area at most, the range being that of the depth or of colours, and may be by 1/4
 * of a step. Callers that find it false need not set v[i].rest. After qtri_triangle_begin().
 */
bool qtri_unsnapped_matters(const qtri_raster *raster, const qtri_triangle *triangle,
                            const uint32_t depth_16p16[3]);

bool qtri_attributes_matter(const qtri_raster *raster, const qtri_triangle *triangle,
                            const qtri_attributes v[3]);

/*
 * The weights. It is off when that does not matter, when no rest is known, or when the triangle is
 * so thin, a fifth of a pixel, that they are large: what is then covered may lie anywhere about the
 * true triangle.
 */
void qtri_unsnapped_init(qtri_unsnapped *unsnapped, const qtri_raster *raster,
                         const qtri_triangle *triangle, const qtri_attributes v[3]);

/* Less at vertex i, in units of f times 2^-up; up <= 16. */
int64_t qtri_unsnapped_less(const qtri_unsnapped *unsnapped, const uint32_t f[3], int i, int up);

/* f at the snapped vertices, held within these bounds; true when one was not. */
bool qtri_unsnapped_move(uint32_t f[3], const qtri_unsnapped *unsnapped, uint32_t least,
                         uint32_t greatest);

/* The same within the range of the three. */
void qtri_unsnapped_move_inside(uint32_t f[3], const qtri_unsnapped *unsnapped);

/* The plane of f, below 2^31, at the snapped vertices: there it may be some below 0. */
void qtri_unsnapped_plane(qtri_plane *plane, const qtri_gradient *gradient,
                          const qtri_unsnapped *unsnapped, const uint32_t f[3]);

#endif
