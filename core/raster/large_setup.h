/* SPDX-License-Identifier: MIT */
/*
 * A large triangle on its way: edges, planes, and where it is along a row. Internal.
 *
 * An attribute is a number below 2^29 at the vertices, counted from the least of them or from whole
 * repeats of a texture. With perspective, planes hold it times q, and q, which is 1/w in 2^-31 of
 * the greatest vertex's; without, the attribute itself.
 */
#ifndef QTRI_RASTER_LARGE_SETUP_H
#define QTRI_RASTER_LARGE_SETUP_H

#include "qtri/body/large.h"

#include "dda.h"
#include "fine_plane.h"
#include "large.h"
#include "large_levels.h"
#include "residual.h"

enum {
    QTRI_LARGE_ATTRIBUTES = 6, /* u v, light or red green blue, alpha */
    QTRI_LARGE_CHUNK_LOG2 = 7, /* points begin anew every 2^this pixels of a row */
    QTRI_LARGE_CHUNK = 1 << QTRI_LARGE_CHUNK_LOG2,
    QTRI_LARGE_COLOR_UP = 5, /* bits that colours, 8.16, gain */
    QTRI_LARGE_NO_LEVEL = 31 /* log2 of no row's pixels */
};

/* Colours of pieces: none, one attribute as it is, a word of 565, lanes of 8.8 or 9.7. */
enum { QTRI_PACK_NONE, QTRI_PACK_ONE, QTRI_PACK_565, QTRI_PACK_888, QTRI_PACK_WEIGHTS };

typedef struct qtri_large_job {
    qtri_large t;                     /* first: what the body has a pointer to */
    uint8_t pixel_bytes, depth_bytes; /* depth_bytes: 0 without a test of depth */
    const qtri_options *options;
    const qtri_large_vertex *v;

    const qtri_screen_point *const *p;
    int64_t area;
    qtri_large_edges edges;
    uintptr_t row_pixel, row_depth; /* addresses of column 0 */
    ptrdiff_t pitch, depth_pitch;
    uint32_t row_z;         /* depth of column 0 */
    int32_t x_first, x_end; /* columns of the bounds */
    /* The row, inside of the frame. */
    int32_t frame_width;
    int32_t row_left, row_right;
    bool is_new; /* nothing of it is found yet */
    int32_t next_left,
        next_right; /* of a row whose depth leaves its range: what is not drawn yet */

    int32_t x_least, y_least, width, height; /* of the triangle, 24.8 */
    int32_t pixels;                          /* of its longer side */
    qtri_gradient gradient;
    qtri_residual residual;
    qtri_ramp depth;
    bool clamps_depth; /* it may leave its range; is_clamped: it is out of it where the row is */
    bool is_clamped;
    int32_t depth_above; /* bits 32.. of depth.origin */

    uint8_t first_color, alpha, count; /* attributes: u v if textured, colours, alpha */
    uint8_t packing;                   /* of colours: below */
    uint8_t run_log2;                  /* pixels that colours may be stepped */
    uint32_t q_at[3];
    uint8_t q_up; /* planes are times 2^this, q_at is not */
    qtri_large_plane q;
    int32_t plane_y;                              /* of planes' rows */
    bool is_curved;                               /* planes are times q */
    bool may_be_level;                            /* q hardly changes along rows: by `steep` */
    uint32_t steep;                               /* 2^-16 a pixel */
    int8_t steps_log2;                            /* of pieces that steps are for */
    uint8_t level_log2;                           /* of the row's pixels that steps are for */
    bool is_level;                                /* nor in this row */
    int32_t q_slope_log2, chord_log2, texel_log2; /* see large_curves.c */
    int32_t piece_max;                            /* log2 of the longest piece */
    int32_t one_log2;         /* of pieces, where one length serves all rows; else -1 */
    qtri_large_levels levels; /* of a texture that is mipmapped */
    uint32_t center[3];       /* half of what rounding of packed steps sums up to, n.16 */

    qtri_ramp run_ramp[3]; /* with t.has_runs */

    int32_t chunk_end, h_log2; /* h_log2: of a piece; -1: points are a pixel apart */
    int32_t zeros;             /* of q at the last point */
    uint32_t delta_step;       /* of q from a point to the next */
    int32_t delta;             /* (q1 - q0) / 2 q at the last point, Q16 */
} qtri_large_job;

/* In large.c: edges of a triangle, from the first row on that is drawn; false: there is none. */
bool qtri_large_edges_init(qtri_large_edges *edges, const qtri_rect *bounds,
                           const qtri_screen_point *const vertex[3], bool clockwise);
/* What a triangle that is drawn from row t.y + 1 on has but its edges. */
void qtri_large_set_box(qtri_large_job *job, const qtri_screen_point *const p[3]);
void qtri_large_set_up(qtri_large_job *job, const qtri_screen_point *const p[3], int64_t area);

/* In large_rows.c: columns `left` to `right` of row t.y are what is drawn next; false: nothing of
   it is within the bounds. */
bool qtri_large_set_row(qtri_large_job *job, int32_t left, int32_t right);

/* The columns of a row; row by row. */
static inline void qtri_large_edges_next(qtri_large_edges *e, int32_t y, int32_t *left,
                                         int32_t *right)
{
    if (y == e->turn) {
        *(e->lower_is_left ? &e->left : &e->right) = e->lower;
    }
    *left = e->left.value;
    *right = e->right.value;
    qtri_dda_next(&e->left);
    qtri_dda_next(&e->right);
}

/* The row below: where it begins, and its depth. */
static inline void qtri_large_step_row(qtri_large_job *job)
{
    job->t.y++;
    job->row_pixel += (uintptr_t)job->pitch;
    job->row_depth += (uintptr_t)job->depth_pitch;
    job->row_z += job->depth.dy;
}

static inline qtri_large_job *qtri_large_job_of(qtri_large *t)
{
    return (qtri_large_job *)(void *)t;
}

/* The texture is mipmapped, and has levels. */
static inline bool qtri_large_has_levels(const qtri_large_job *job)
{
    return job->options->mipmapped && job->t.state->last_level != 0;
}

static inline uint32_t qtri_large_whole(uint64_t value)
{
    return (uint32_t)(value >> 32);
}

/* The whole part at a column, |x| <= 2^14: 16 bits of the fraction count. */
static inline uint32_t qtri_large_plane_at(const qtri_large_plane *p, int32_t x)
{
    const int32_t rest = (int32_t)(p->dx >> 16 & 0xFFFFu) * x + (int32_t)(p->row >> 16 & 0xFFFFu);
    return qtri_large_whole(p->row) + qtri_large_whole(p->dx) * (uint32_t)x +
           (uint32_t)(rest >> 16);
}

/* All of it there, to 2^-16. */
static inline uint64_t qtri_large_plane_from(const qtri_large_plane *p, int32_t x)
{
    const int32_t rest = (int32_t)(p->dx >> 16 & 0xFFFFu) * x + (int32_t)(p->row >> 16 & 0xFFFFu);
    const uint32_t whole =
        qtri_large_whole(p->row) + qtri_large_whole(p->dx) * (uint32_t)x + (uint32_t)(rest >> 16);
    return (uint64_t)whole << 32 | (uint32_t)rest << 16;
}

/* q, which rounding may leave at 0 or below. */
static inline uint32_t qtri_large_positive(uint32_t q)
{
    return q - 1 < 0xE0000000u ? q : 1;
}

/* In large_planes.c: planes go on to the job's row. */
void qtri_large_planes_move(qtri_large_job *job);

/* In large_colors.c: how colours of the options are packed; the half that rounds; colours, 8.16 of
   255, as they are stepped, n.16: gray is the first one. */
uint8_t qtri_large_packing_of(const qtri_options *o);
uint32_t qtri_large_half_of(const qtri_options *o);
void qtri_large_channels(int packing, uint32_t out[3], const uint32_t color_8p16[3]);
void qtri_large_pack_colors(int packing, qtri_large_piece *piece, const uint32_t *c,
                            const uint32_t *step, int32_t n);
/* colours and alpha of a piece of n pixels, from n.16 of each attribute. */
void qtri_large_pack(const qtri_large_job *job, qtri_large_piece *piece,
                     const uint32_t at[QTRI_LARGE_ATTRIBUTES],
                     const uint32_t step[QTRI_LARGE_ATTRIBUTES], int32_t n);
/* Those of a run of a row along which they are linear; its steps, before. */
void qtri_large_pack_linear(qtri_large_job *job, qtri_large_piece *piece);
void qtri_large_set_run_steps(qtri_large_job *job);

/* In large_pieces.c: pieces of a row along which attributes are linear, from `at` and `step`. */
int32_t qtri_large_linear_piece(qtri_large_job *job);
/* Colours of a piece go on by n pixels. */
void qtri_large_skip_colors(const qtri_options *o, qtri_large_piece *piece, uint32_t n);
/* Drops what lies outside of x0..x1 - 1 of a piece that starts at `x`; where textures have levels,
   which come before that, only the second function does. */
void qtri_large_clip(qtri_large_job *job, qtri_large_piece *piece, int32_t x);
void qtri_large_cut(qtri_large_job *job, qtri_large_piece *piece, int32_t x);

/* In large_curves.c: how far points are apart. Then rows: sets job->is_level, and steps along the
   row if it is; planes are the row's. */
void qtri_large_set_lengths(qtri_large_job *job);
bool qtri_large_begin_level(qtri_large_job *job);

#endif
