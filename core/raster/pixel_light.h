/* SPDX-License-Identifier: MIT */
/*
 * Per-pixel light: colours along rows of large triangles, for a pipeline's loop over pixels.
 * Internal.
 *
 * Reached through a draw call's state, so that what does not name &qtri_per_pixel does not link it.
 */
#ifndef QTRI_RASTER_PIXEL_LIGHT_H
#define QTRI_RASTER_PIXEL_LIGHT_H

#include "qtri/body/large.h"

#include "../geometry/illumination.h"
#include "large_setup.h"

#define QTRI_LIT_ONE_Q30 ((int32_t)1 << 30)

/* A vertex of a triangle of a mesh before clipping, in local coordinates. */
typedef struct qtri_lit_corner {
    int32_t normal_q14[3];
    int32_t place[3], exponent; /* the position, see qtri_lit_point */
    qtri_rgb color;
} qtri_lit_corner;

typedef struct qtri_lit_triangle {
    const qtri_illumination *by;
    bool one_normal, one_color;
    qtri_lit_corner corner[3];
    /* Corners 1 and 2 less corner 0. */
    int32_t across[2][3]; /* positions, times 2^up: below 2^30 */
    int32_t up;
    int32_t normal_delta_q14[2][3];
    /* The triangle of the mesh whose corners these are, or NULL. Small ones may have: a channel, in
       2^-7, is k[0] + k[1] b1 + k[2] b2 + k[3] b1^2 + k[4] b2^2 + k[5] b1 b2 of their shares b. */
    const void *indices;
    bool is_quadratic;
    int32_t k[3][6];
} qtri_lit_triangle;

/* Sets corner i: position and normal of `point`, and its colour before light. */
void qtri_lit_set_corner(qtri_lit_triangle *p, int i, const qtri_lit_point *point,
                         const qtri_rgb *color);

enum { QTRI_LIGHT_BLOCK_LOG2 = 4 /* pixels from sample to sample, at most */ };

/* A lit colour in column x, in the channels that qtri_large_packing steps. */
typedef struct qtri_light_sample {
    int32_t x;
    uint32_t c[3];
} qtri_light_sample;

/* Per-pixel light of a draw call: of the current triangle, row and block. */
typedef struct qtri_large_light {
    qtri_light_walk walk; /* first: the state points to it */
    qtri_lit_triangle lit;
    uint8_t block_log2; /* pixels from sample to sample */

    /* The triangle: shares (barycentric) of corners 1 and 2, 2^30 is 1; divided: times q = 1/w,
       2^31 at most. */
    bool divided;
    int32_t plane_y; /* of the planes' row */
    qtri_large_plane share[2], q;
    uint32_t least, greatest; /* of the vertices' q */
    int32_t tolerance[3];     /* of a second difference */

    /* The row: its span, which a scissor does not change; the first pixel and the next one. */
    int32_t y, left, last, x0, x;
    bool is_alone; /* pixels are lit one by one: at edges with four samples few follow */
    qtri_light_sample sample[3]; /* of a block: from, to, and the one after */
    uint8_t from;                /* index of the first */
    bool bends;                  /* light is not straight at it */

    /* The rest of a block that is halved: a stack of parts, from `at` to end[count - 1], and on to
       end[0]; whether they are to be halved again. */
    qtri_light_sample at, end[QTRI_LIGHT_BLOCK_LOG2 + 1];
    bool bent[QTRI_LIGHT_BLOCK_LOG2 + 1];
    uint8_t count;
    int32_t piece_x, piece_end; /* columns where walk.piece starts, and after it */
} qtri_large_light;

/*
 * Calls `body` while the state's triangles are lit by pixel. Before each the corners of
 * state->light_walk are set, see qtri_large_light_triangle(); large triangles bring the shares of
 * corners 1 and 2, 2^30 being 1, in place of red and green.
 */
typedef void (*qtri_lit_body)(void *with);
void qtri_large_light_run(qtri_draw_state *state, const qtri_illumination *by, qtri_lit_body body,
                          void *with);

/* Whether the state's small triangle, whose corners are set, may be lit at them: state->lit. */
bool qtri_large_light_is_linear(qtri_draw_state *state);

static inline qtri_lit_triangle *qtri_large_light_triangle(qtri_draw_state *state)
{
    return &((qtri_large_light *)(void *)state->light_walk)->lit;
}

#endif
