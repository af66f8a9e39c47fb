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

/* 2^-32 of a unit: the upper word is what is whole. */
typedef struct qtri_large_plane {
    uint64_t row; /* at column 0 of the row */
    uint64_t dx, dy;
    uint64_t s, s_step; /* at the next point of the row */
} qtri_large_plane;

typedef struct qtri_large_attribute {
    qtri_large_plane plane;
    uint32_t f[3];        /* of the vertices */
    uint32_t least, most; /* of colours: 8.16, f counts from the least */
    uint32_t start;       /* what is added where pieces start: the least, the half that rounds */
    int8_t up;            /* pieces have f 2^up */
    int32_t point;        /* a quarter of the attribute at the point that was found last */
    uint8_t at_left, at_right, step_left, step_right, bend_left, bend_right;
    uint32_t at, step;            /* along a row where it is linear */
    uint32_t c, x, y, xx, xy, yy; /* c + x X + y Y + xx X^2 + xy X Y + yy Y^2 */
} qtri_large_attribute;

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
    qtri_large_attribute a[QTRI_LARGE_ATTRIBUTES];
    uint32_t q_at[3];
    uint8_t q_up; /* planes are times 2^this, q_at is not */
    qtri_large_plane q;
    int32_t plane_y;                              /* of planes' rows */
    bool is_curved;                               /* planes are times q */
    bool is_near;                                 /* polynomials of second order serve */
    uint8_t near_log2;                            /* pixels of its pieces */
    bool may_be_level;                            /* q hardly changes along rows: by `steep` */
    uint32_t steep;                               /* 2^-16 a pixel */
    int8_t steps_log2;                            /* of pieces that steps are for */
    uint8_t level_log2;                           /* of the row's pixels that steps are for */
    bool is_level;                                /* nor in this row */
    int32_t q_slope_log2, chord_log2, texel_log2; /* see large_lengths.c */
    int32_t piece_max;                            /* log2 of the longest piece */
    int32_t one_log2; /* of pieces, where one length serves all rows; else -1 */
    int32_t middle_x, middle_y;
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

static inline uint32_t qtri_large_shift(uint32_t x, int32_t up)
{
    return up >= 0 ? x << up : (uint32_t)((int32_t)x >> (up < -31 ? 31 : -up));
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

/* By how much, n.16, colours may stray for going along chords: 1/4 of a step. */
static inline int32_t qtri_large_chord_bound_log2(const qtri_large_job *job)
{
    return job->packing != QTRI_PACK_565 && qtri_stores_565(job->options) ? 16 : 14;
}

/* In large_lengths.c: how steep coordinates are along rows; log2 of the texels that a pixel steps
   where q is this or more, rounded up, 0 at least; how far points are apart. */
void qtri_large_set_texel_slope(qtri_large_job *job);
int32_t qtri_large_texels_log2(const qtri_large_job *job, uint32_t q);
void qtri_large_set_lengths(qtri_large_job *job);
/* log2 of a piece's pixels where q is this or more; may be negative. Points a piece apart must have
   q' 4 h <= q, so that q is positive at the point behind a row's end. */
int32_t qtri_large_length_for(const qtri_large_job *job, uint32_t q);

/* In large_curves.c. Sets job->is_level, and steps along the row if it is; planes are the row's. */
bool qtri_large_begin_level(qtri_large_job *job);

/* In large_near.c. */
bool qtri_large_set_near(qtri_large_job *job);
int32_t qtri_large_near_piece(qtri_large_job *job);

/* floor(a b / 2^32), 0 <= b. */
static inline int32_t qtri_large_mul_high(int32_t a, int32_t b)
{
#if QTRI_LONG_MULTIPLY
    return (int32_t)(qtri_mul_s32(a, b) >> 32);
#else
    return qtri_mul_high_s31(a, (uint32_t)b);
#endif
}

/* s 2^zeros, 32 bits of it. */
static inline uint32_t qtri_large_left(uint64_t s, int32_t zeros)
{
    return qtri_large_whole(s) << zeros | (uint32_t)s >> 1 >> (31 - zeros);
}

/* 2^62 / q 2^zeros, below 2^31; sets job->zeros. q: 2^-32. */
static inline int32_t qtri_large_reciprocal(qtri_large_job *job, uint64_t q_q32)
{
    const uint32_t q = qtri_large_positive(qtri_large_whole(q_q32));
#if QTRI_LONG_MULTIPLY
    const int32_t zeros = qtri_clz32(q);
#else
    int32_t zeros = job->zeros; /* of the point before nearly as many */
    while (q >> (31 - zeros) > 1) {
        zeros--;
    }
    while ((int32_t)(q << zeros) >= 0) {
        zeros++;
    }
#endif
    job->zeros = zeros;
    const uint32_t r = qtri_reciprocal_near(q << zeros | (uint32_t)q_q32 >> 1 >> (31 - zeros));
    return (int32_t)(r - (r >> 31));
}

/* A quarter of what is s / q; s 2^-32. */
static inline int32_t qtri_large_quotient(uint64_t s, int32_t zeros, int32_t reciprocal)
{
    return qtri_large_mul_high((int32_t)qtri_large_left(s, zeros), reciprocal);
}

#endif
