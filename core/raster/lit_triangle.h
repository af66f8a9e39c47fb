/* SPDX-License-Identifier: MIT */
/*
 * Light at the pixels of a triangle, from what its corners are in the mesh that it is of: places,
 * normals and colours between them, in shares of corners 1 and 2. Internal.
 */
#ifndef QTRI_RASTER_LIT_TRIANGLE_H
#define QTRI_RASTER_LIT_TRIANGLE_H

#include "../geometry/illumination.h"
#include "job.h"
#include "triangle.h"

#define QTRI_LIT_ONE_Q30 ((int32_t)1 << 30)

/* A corner of a triangle of a mesh, before it is clipped. Direction and place are local. */
typedef struct qtri_lit_corner {
    int32_t normal_q14[3];
    int32_t place[3];
    int32_t exponent; /* of the place */
    qtri_rgb color;
} qtri_lit_corner;

/* What a pixel shows: channels in the raster's units. */
typedef struct qtri_lit_sample {
    int32_t x, y;
    int32_t c[3];
} qtri_lit_sample;

struct qtri_pixel_light {
    /* Colours of a chunk of a row into the batch, or its texels times them. */
    void (*shade)(qtri_scanline *row, int32_t x, int32_t count);
    const qtri_illumination *by;
    qtri_route next;    /* what the raster had; NULL: none */
    bool everywhere;    /* light is the same at every place */
    int32_t block_log2; /* of pixels from sample to sample */
    qtri_lit_corner corner[3];
    /* Of the triangle: corners 1 and 2 less corner 0. */
    int32_t across[2][3]; /* places, times 2^up: below 2^30 */
    int32_t up;
    int32_t turn_q14[2][3]; /* normals */
    bool one_normal, one_color;
    /* Shares of corners 1 and 2, 2^30 is 1; divided: times q = 1/w, 2^31 at most, and q. */
    bool divided;
    qtri_plane share[2];
    qtri_plane q;
    uint32_t least, greatest;  /* of the vertices' q */
    qtri_lit_sample sample[3]; /* the first two: where the last chunk ended, and the next one */
    bool bends;                /* between them and the one before */
    int32_t left, right;       /* the span that they are of: four samples have several in a row */
};

/* Places in one scale, that of the farthest, and what corners 1 and 2 differ in from corner 0. */
void qtri_lit_set_corners(qtri_pixel_light *p);

/* Shares on the screen, of what is left of the triangle. No sample is known of it. */
void qtri_lit_set_planes(qtri_pixel_light *p, const qtri_raster *raster,
                         const qtri_triangle *triangle, const qtri_attributes v[3]);

/* The point with these shares, as the raster's channels; and that of a pixel it covers. */
void qtri_lit_channels(int32_t channel[3], const qtri_pixel_light *p, const qtri_raster *raster,
                       const int32_t b_q30[2]);
void qtri_lit_sample_at(qtri_lit_sample *out, const qtri_pixel_light *p, const qtri_raster *raster,
                        int32_t x, int32_t y);

#endif
