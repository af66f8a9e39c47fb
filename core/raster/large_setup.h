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

#include "../bits/bits.h"

#include "dda.h"

enum {
    QTRI_LARGE_CHUNK_LOG2 = 7, /* points begin anew every 2^this pixels of a row */
    QTRI_LARGE_CHUNK = 1 << QTRI_LARGE_CHUNK_LOG2,
    QTRI_LARGE_COLOR_UP = 5, /* bits that colours, 8.16, gain */
    QTRI_LARGE_NO_STEPS = 31 /* steps are to be set anew */
};

/* In large.c: edges of a triangle, from the first row on that is drawn; false: there is none. */
bool qtri_large_edges_init(qtri_large_edges *edges, const qtri_rect *bounds,
                           const qtri_point *const vertex[3], bool clockwise);
/* All of a triangle but its edges; t.y is the row before the first. */
void qtri_large_set_box(qtri_large *t, const qtri_point *const p[3], int64_t area);
void qtri_large_set_up(qtri_large *t);

/* First row whose centre is at or below y, or column whose centre is at or right of x. */
static inline int32_t qtri_large_first_center(int32_t at_24p8)
{
    return (at_24p8 + 127) >> 8;
}

/* Columns `left` to `right` of row t.y are drawn next, as far as they are within the bounds. */
static inline void qtri_large_set_row(qtri_large *t, int32_t left, int32_t right)
{
    t->x0 = qtri_greatest32(left, t->bounds_left);
    t->x1 = qtri_least32(right, t->bounds_right);
}

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
static inline void qtri_large_step_row(qtri_large *t)
{
    t->y++;
    t->row_pixel += (uintptr_t)t->pitch;
    t->row_depth += (uintptr_t)t->depth_pitch;
    t->row_z += t->row_z_step;
}

/* The texture is mipmapped, and has levels. */
static inline bool qtri_large_has_levels(const qtri_large_job *job)
{
    return job->t.options->mipmapped && job->t.state->last_level != 0;
}

static inline uint32_t qtri_large_whole(uint64_t value)
{
    return (uint32_t)(value >> 32);
}

/* A plane at a column, |x| <= 2^14: 16 bits of the fraction count. */
static inline uint64_t qtri_large_plane_from(const qtri_large_plane *p, int32_t x)
{
    const int32_t rest = (int32_t)(p->dx >> 16 & 0xFFFFu) * x + (int32_t)(p->row >> 16 & 0xFFFFu);
    const uint32_t whole =
        qtri_large_whole(p->row) + qtri_large_whole(p->dx) * (uint32_t)x + (uint32_t)(rest >> 16);
    return (uint64_t)whole << 32 | (uint32_t)rest << 16;
}

static inline uint32_t qtri_large_plane_at(const qtri_large_plane *p, int32_t x)
{
    return qtri_large_whole(qtri_large_plane_from(p, x));
}

/* By how many bits a side of the texture is shorter at a level, 0: width, 1: height. */
static inline uint32_t qtri_large_level_down(const qtri_large_job *job, int i, uint32_t level)
{
    const uint32_t height_log2 = job->t.state->height_log2;
    return i == 1 && level > height_log2 ? height_log2 : level;
}

/* Coordinates along a row where they are linear, so many pixels on. */
static inline void qtri_large_set_straight(const qtri_large_job *job, qtri_large_piece *piece,
                                           uint32_t skipped)
{
    for (int i = 0; i < 2; i++) {
        piece->uv[i].at = job->a[i].at + job->a[i].step * skipped;
        piece->uv[i].step = job->a[i].step;
        piece->uv[i].bend = 0;
    }
}

/* q, which rounding may leave at 0 or below. */
static inline uint32_t qtri_large_positive(uint32_t q)
{
    return q - 1 < 0xE0000000u ? q : 1;
}

/* In large_setup.c: weights, of true positions where these are known and the triangle is not too
   thin; then those of true or of snapped positions. */
void qtri_large_set_weights(qtri_large *t);
void qtri_large_use_weights(qtri_large *t, bool true_positions);

/* The plane through (vertex i, f[i]) by these weights, in row plane_y: of whole values below 2^31.
 */
void qtri_large_plane_of(qtri_large_plane *p, const qtri_large *t, const uint32_t f[3]);

/* The ramp of values in 2^-down of its units; steps are rounded from vertex 0 on, or from where the
   frame is nearest to it. */
void qtri_large_ramp_init(qtri_large_ramp *ramp, const qtri_large *t, const int64_t f_q8[3],
                          int32_t down);

/* 1/w of the vertices with one exponent, 2^-8; not 0. */
void qtri_large_align_q(int64_t q_q8[3], const qtri_large_vertex v[3]);

/* Linear planes where perspective cannot be seen, else false and 1/w of the vertices; then its
   planes. */
bool qtri_large_set_linear(qtri_large_job *job, int64_t q_q8[3]);
void qtri_large_set_curved(qtri_large_job *job, const int64_t q_q8[3]);

/* In large_pieces.c: planes go on to the job's row. */
void qtri_large_planes_move(qtri_large_job *job);

/* In large_pieces.c: colours and alpha of a piece of n pixels, from n.16 of each attribute; of one
   along which they are linear, a run at most. */
void qtri_large_pack(const qtri_large_job *job, qtri_large_piece *piece,
                     const uint32_t at[QTRI_LARGE_ATTRIBUTES],
                     const uint32_t step[QTRI_LARGE_ATTRIBUTES], int32_t n);
void qtri_large_pack_linear(const qtri_large_job *job, qtri_large_piece *piece);

/* In large_pieces.c: pieces of a row along which attributes are linear, from `at` and `step`. */
int32_t qtri_large_linear_piece(qtri_large_job *job);
/* In large_pieces.c: a piece goes on by n of its pixels. */
void qtri_large_skip(const qtri_large_job *job, qtri_large_piece *piece, uint32_t n);
/* In large_colors.c: its packed colours go on by n pixels. */
void qtri_large_skip_colors(qtri_large_piece *piece, uint32_t n);
/* Drops what lies outside of x0..x1 - 1 of a piece that starts at `x`; where textures have levels,
   which come before that, only the second function does. */
void qtri_large_clip(qtri_large_job *job, qtri_large_piece *piece, int32_t x);
void qtri_large_cut(qtri_large_job *job, qtri_large_piece *piece, int32_t x);

/* In large_setup.c: of an axis that needs to be clamped, at a level. */
qtri_large_zone qtri_large_zone_of(const qtri_large_job *job, int i, uint32_t level);

/* In large_clamp.c, where an axis needs to be clamped: makes piece[0] what is next of pieces that
   were found; false: nothing is left of them. Clamps pieces that are found now; returns how many
   there are. */
bool qtri_large_next_rest(qtri_large_job *job);
int32_t qtri_large_clamp_pieces(qtri_large_job *job, int32_t pieces);

/* In large_curves.c: pieces, before they are clamped, of any attributes or of coordinates alone,
   without knots; returns how many. */
int32_t qtri_large_find_pieces(qtri_large_job *job);
int32_t qtri_large_next_halves(qtri_large_job *job);
/* In large_curves.c: sets job->row_is_linear, and steps along the row if it is; planes are the
   row's. */
void qtri_large_begin_linear_row(qtri_large_job *job);

#endif
