/* SPDX-License-Identifier: MIT */
/*
 * A block of a row with perspective, see perspective.c: how long it is and what its middle has,
 * then curves through it. In two parts and in place, as mipmap_span.c asks between them which level
 * is drawn there. Internal.
 */
#ifndef QTRI_RASTER_PERSPECTIVE_BLOCK_H
#define QTRI_RASTER_PERSPECTIVE_BLOCK_H

#include "perspective.h"

#include "../bits/multiply.h"
#include "../bits/reciprocal.h"
#include "../frame/curves.h"

/*
 * What curves of a block have in common, as shares of L. With A = e (1 + ...), T = e^2 and `half`
 * pixels from the first to the middle, a curve's first value is
 *
 *     a_m - L (1 + A half + T half^2) half,
 *     step L (1 + (2 half - 1) A + (3 half^2 - 3 half - 20) T),
 *     bend L (- 2 A - (6 half - 24) T),   twist L 24 T
 *
 * where - 21 T of the step and 18 T of the bend make a curve of second order pass through the
 * fourth and the eighth pixel from where it begins, and where it does so again after every eighth.
 * Without a third order T is 0 but in A and L.
 */
typedef struct qtri_block {
    int32_t x, half, log2; /* pixel; log2 of a whole block, once shares are set of half of one */
    int32_t zeros;
    uint32_t q;          /* times 2^zeros: 2^31 or more */
    uint32_t reciprocal; /* 2^62 / (q 2^zeros) */
    int32_t square;      /* 15 bits of that squared */
    int32_t slope_down;
    int32_t value_q16, step_q16; /* without 1 */
    int32_t bend_q15;            /* times 2^log2 */
    int32_t twist_q12;           /* times 4^log2 */
} qtri_block;

/* A plane at a pixel of the row: |x| <= 2^14, so that products of the rest fit 31 bits. */
static inline uint32_t qtri_row_plane_at(const qtri_row_plane *row, const qtri_projected *plane,
                                         int32_t x)
{
    return row->at + plane->dx * (uint32_t)x +
           (uint32_t)((row->rest + (int32_t)plane->dx_rest * x) >> 16);
}

/* 1/w at a pixel of the row: where it is all but 0, rounding may leave it there or below. */
static inline uint32_t qtri_row_inv_w_at(const qtri_scanline *row, int32_t x)
{
    const qtri_job *job = row->job;
    const uint32_t q = qtri_row_plane_at(&row->by.perspective.plane[job->end],
                                         &job->attribute[job->end].projected, x);
    return q - 1 < 0xC0000000u ? q : 1;
}

/* Leading zeros of q, not 0: of the block before nearly as many. */
static inline int32_t qtri_row_zeros(qtri_scanline *row, uint32_t q)
{
#if QTRI_LONG_MULTIPLY
    (void)row;
    return qtri_clz32(q);
#else
    int32_t zeros = row->by.perspective.zeros;
    while (q >> (31 - zeros) > 1) {
        zeros--;
    }
    while ((int32_t)(q << zeros) >= 0) {
        zeros++;
    }
    row->by.perspective.zeros = zeros;
    return zeros;
#endif
}

/* log2: of a whole block, 1 or more. */
static inline void qtri_block_set_shares(qtri_block *m, const qtri_perspective *p, int32_t log2,
                                         bool twisted)
{
    const uint32_t y_q15 = m->reciprocal >> 16; /* 2^14..2^15 */
    /* E = e h, at most 1/8 of it, so that the shift is not negative. */
    int32_t down = -(p->slope_exponent + m->zeros + log2);
    down = down > 31 ? 31 : down;
    log2--;
    m->log2 = log2;
    const int32_t e_q16 = (p->slope * (int32_t)y_q15) >> down;
    const int32_t e2_q16 = (e_q16 * e_q16) >> 16;
    /* The reciprocal's square: 30 bits, of which 15 count, times 15/16 (1 + 3/4 E^2) <= .99. */
    uint32_t square = y_q15 * y_q15 + ((y_q15 * qtri_low16(m->reciprocal)) >> 15); /* 2^28..2^30 */
    square -= square >> 4;
    const int32_t half = m->half;
    if (twisted) {
        const int32_t a_q16 = e_q16 + ((13 * e_q16 * e2_q16) >> 20);
        const int32_t arc = (a_q16 * half) >> log2;
        const int32_t t1 = (e2_q16 * half) >> log2; /* T half h */
        const int32_t t2 = (t1 * half) >> log2;
        m->value_q16 = arc + t2;
        m->step_q16 = 2 * arc + 3 * t2 - ((a_q16 + 3 * t1 + (20 * e2_q16 >> log2)) >> log2);
        m->bend_q15 = (12 * e2_q16 >> log2) - a_q16 - 3 * t1;
        m->twist_q12 = (24 * e2_q16) >> 4;
    } else {
        const int32_t a_q16 = e_q16 + ((4 * e_q16 * e2_q16) >> 20); /* of 1 + 3/4 E^2 */
        const int32_t arc = (a_q16 * half) >> log2;
        square += (square >> 16) * (uint32_t)(3 * e2_q16 >> 2);
        m->value_q16 = arc;
        m->step_q16 = 2 * arc - (a_q16 >> log2);
        m->bend_q15 = -a_q16;
        m->twist_q12 = 0;
    }
    const int32_t odd = square >> 29 == 0;
    square = ((square << odd) + 0x4000u) >> 15;
    m->square = (int32_t)(square - (square >> 15));
    m->slope_down = odd - 2 * m->zeros;
}

/* Attribute i in the middle, in the unit of curves. */
static inline uint32_t qtri_block_value(const qtri_scanline *row, const qtri_block *m, int i)
{
    const qtri_projected *a = &row->job->attribute[i].projected;
    const uint32_t s = qtri_row_plane_at(&row->by.perspective.plane[i], a, m->x);
    int32_t value = qtri_mul_high_s31((int32_t)(s << m->zeros), m->reciprocal);
    if (i < QTRI_U) {
        const qtri_perspective *p = &row->job->color.perspective;
        value >>= QTRI_COLOR_PERSPECTIVE_SHIFT - 2;
        value = qtri_hold32(value, p->least[i], p->greatest[i]);
        return (uint32_t)value + a->bias;
    }
    return qtri_run_scaled((uint32_t)value + a->bias, a->up);
}

/* A curve whose slope is shifted left, or far right: few are. |l| < 2^30 */
void qtri_curve_set_steep(qtri_curve *out, const qtri_block *m, uint32_t value, int32_t l,
                          int32_t down);

QTRI_IN_PLACE void qtri_block_set_curve(qtri_curve *out, const qtri_block *m, uint32_t value,
                                        const qtri_row_plane *plane, bool twisted)
{
    const int32_t l = plane->slope * m->square;
    const int32_t down = plane->down + m->slope_down;
    if ((uint32_t)down > 22) {
        const qtri_block copy = *m; /* or all of it would be in memory */
        qtri_curve_set_steep(out, QTRI_SMALL_CODE ? m : &copy, value, l, down);
        return;
    }
    const int32_t l_15 = l >> 15;
    const int32_t to_start = (l + ((l_15 * m->value_q16) >> 1)) >> down;
    out->at = value - (uint32_t)to_start * (uint32_t)m->half;
    out->step = (uint32_t)((l + ((l_15 * m->step_q16) >> 1)) >> down);
    out->bend = (uint32_t)((l_15 * m->bend_q15) >> (down + m->log2));
    out->twist =
        twisted ? (uint32_t)((l_15 * m->twist_q12) >> (down + 2 * m->log2 - 3)) : (uint32_t)0;
}

QTRI_IN_PLACE void qtri_block_set_attribute(qtri_scanline *row, const qtri_block *m, int i,
                                            bool twisted)
{
    qtri_block_set_curve(&row->curve[i], m, qtri_block_value(row, m, i),
                         &row->by.perspective.plane[i], twisted);
}

/* Both texture coordinates without a loop, so that they are where the compiler knows. */
QTRI_IN_PLACE void qtri_block_set_curves(qtri_scanline *row, qtri_block *m, int32_t log2, int first,
                                         int end, bool twisted)
{
    qtri_block_set_shares(m, &row->job->color.perspective, log2, twisted);
    if (!QTRI_SMALL_CODE && first == QTRI_U) {
        qtri_block_set_attribute(row, m, QTRI_U, twisted);
        qtri_block_set_attribute(row, m, QTRI_U + 1, twisted);
        return;
    }
    for (int i = first; i < end; i++) {
        qtri_block_set_attribute(row, m, i, twisted);
    }
}

/* log2 of the pixels of the longest block from pixel x of the row on, `from` pixels into a chunk.
 */
static inline int32_t qtri_longest_block(const qtri_scanline *row, const uint32_t *limits,
                                         int32_t x, int32_t from, int32_t rest)
{
    const uint32_t q = qtri_row_inv_w_at(row, x);
    int32_t log2 = QTRI_BLOCK_LOG2;
    while (log2 > 0 && q < limits[log2 - 1]) {
        log2--;
    }
    while (log2 > 0 && (from & (((int32_t)1 << log2) - 1)) != 0) {
        log2--;
    }
    while (log2 > 0 && (int32_t)1 << (log2 - 1) >= rest) {
        log2--;
    }
    return log2;
}

/*
 * What the block at pixel x has in its middle, but for the reciprocal; returns how many pixels it
 * has. limits: of colours or texels.
 */
QTRI_IN_PLACE int32_t qtri_block_begin(qtri_scanline *row, qtri_block *m, const uint32_t *limits,
                                       int32_t x)
{
    const int32_t from = (x - row->left) & (QTRI_BATCH - 1);
    const int32_t rest = qtri_least32(row->right - x, QTRI_BATCH - from);
    m->log2 = qtri_longest_block(row, limits, x, from, rest);
    const int32_t length = qtri_least32((int32_t)1 << m->log2, rest);
    m->half = length >> 1;
    m->x = x + m->half;
    const uint32_t q = qtri_row_inv_w_at(row, m->x);
    m->zeros = qtri_row_zeros(row, q);
    m->q = q << m->zeros;
    return length;
}

/* Then its curves of attributes first..end - 1, into row->curve. */
QTRI_IN_PLACE void qtri_block_end(qtri_scanline *row, qtri_block *m, int first, int end)
{
    const int32_t log2 = m->log2;
    m->reciprocal = qtri_reciprocal_near(m->q);
    if (log2 == 0) {
        for (int i = first; i < end; i++) {
            const qtri_curve one = {qtri_block_value(row, m, i), 0, 0, 0};
            row->curve[i] = one;
        }
    } else { /* two copies of what follows, or one where code is to be small */
        const bool twisted = first == QTRI_U && log2 >= row->job->color.perspective.texels_twisted;
        if (!QTRI_SMALL_CODE && twisted) {
            qtri_block_set_curves(row, m, log2, first, end, true);
        } else {
            qtri_block_set_curves(row, m, log2, first, end, QTRI_SMALL_CODE && twisted);
        }
    }
}

/*
 * Curves of attributes first..end - 1, colours or texture coordinates, not both, from pixel x of
 * the row on, which is not level, into row->curve. Returns for how many pixels they hold, up to
 * `count`. x is a chunk's first pixel or the one after those that the call before gave.
 */
int32_t qtri_interpolate_perspective(qtri_scanline *row, int32_t x, int32_t count, int first,
                                     int end);

#endif
