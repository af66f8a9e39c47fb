/* SPDX-License-Identifier: MIT */
/*
 * Light at the points of a triangle, from what its corners are in the mesh that it is of: places,
 * normals and colours between them, in shares of corners 1 and 2. Internal.
 */
#ifndef QTRI_RASTER_LIT_TRIANGLE_H
#define QTRI_RASTER_LIT_TRIANGLE_H

#include "../geometry/illumination.h"

#define QTRI_LIT_ONE_Q30 ((int32_t)1 << 30)

/* A corner of a triangle of a mesh, before it is clipped. Direction and place are local. */
typedef struct qtri_lit_corner {
    int32_t normal_q14[3];
    int32_t place[3];
    int32_t exponent; /* of the place */
    qtri_rgb color;
} qtri_lit_corner;

typedef struct qtri_lit_triangle {
    const qtri_illumination *by;
    bool one_normal, one_color;
    qtri_lit_corner corner[3];
    /* Corners 1 and 2 less corner 0. */
    int32_t across[2][3]; /* places, times 2^up: below 2^30 */
    int32_t up;
    int32_t turn_q14[2][3]; /* normals */
    /* The triangle of the mesh whose corners these are, or NULL. Small ones may have: a channel, in
       2^-7, is k[0] + k[1] b1 + k[2] b2 + k[3] b1^2 + k[4] b2^2 + k[5] b1 b2 of their shares b. */
    const void *indices;
    bool is_quadratic;
    int32_t k[3][6];
} qtri_lit_triangle;

/* Corner i, as the point and colour are that light falls on. */
void qtri_lit_set_corner(qtri_lit_triangle *p, int i, const qtri_lit_point *point,
                         const qtri_rgb *color);

/*
 * Whether colours are linear between the corners, which show these, 0x00RRGGBB, and if not whether
 * they are quadratic: within `tolerance`, in 2^-7 of a step of 255. Sets the corners.
 */
bool qtri_lit_is_linear(qtri_lit_triangle *p, const uint32_t corner[3], int32_t tolerance);

/* Places in one scale, that of the farthest, and what corners 1 and 2 differ in from corner 0. */
void qtri_lit_set_corners(qtri_lit_triangle *p);

/* The colour of the point with these shares, 2^30 being 1, whose sum is less: 255.0 at most. */
void qtri_lit_color(uint32_t color_8p16[3], const qtri_lit_triangle *p, const int32_t b_q30[2]);

#endif
