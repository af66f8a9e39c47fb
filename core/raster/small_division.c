/* SPDX-License-Identifier: MIT */
/*
 * Values over small triangles by division, where they bend too much for a curve over the whole
 * triangle (small_curves.h).
 *
 * With q what 1/w has more than at vertex 0 by its value there, s = f (1 + q) is linear, f being
 * what a value has more. At points n columns apart f = s / (1 + q) is found by a reciprocal.
 * Between two of them, `rise` apart, with eps = (q_2 - q_1) / (2 + q_1 + q_2), it is above the
 * chord by
 *
 *     rise eps / 2 (1 - z^2) / (1 + eps z), z from -1 to 1.
 *
 * A parabola through the points and the middle has 1 in place of the last divisor: it is off by
 * rise eps^2 / 2 times .385, the maximum of z (1 - z^2), or .0481 rise (q_2 - q_1)^2, and terms of
 * higher order; 2/35 is allowed for.
 *
 * Of a cube of 90 pixels, turned by 45 degrees, a Cortex-M0+ takes 40 % less than by large
 * triangles where its vertices have colours, and a Cortex-M3 30 %; turned by 15 degrees 33 % and
 * 25 %, of which points less than 8 columns apart are all.
 *
 * Points count from the leftmost column of the triangle, so that what is drawn of it changes none;
 * of light and colours from a multiple of their chords, which begin at points then.
 */
#include "small_curves.h"

#include "../bits/bits.h"

enum {
    FRACTION = 4,   /* bits that s has more than ramps of differences */
    LEAST_LOG2 = 1, /* of columns between points */
    MOST_LOG2 = 7,
    CHORD_LOG2 = 4, /* of pixels of the longest chord, as packed colours have it at most */
    MOST_TEXELS = 4 /* a pixel: where there are more the snap of vertices shows */
};

/* 1 / (1 + q), Q16, of 1 + q in Q15 from 1/2 to 2. */
static inline int32_t reciprocal_of(uint32_t x)
{
    return (int32_t)(x >= 0x8000 ? qtri_small_reciprocal(x) : qtri_small_reciprocal(2 * x) << 1);
}

/* The steepest slope, at q = 0, of a value that is f more at vertices 1 and 2. The slope of f times
   (1 + q)^2, s' (1 + q) - s q', does not change along rows: it is steepest at a vertex. */
static uint32_t slope_of(const qtri_small_ramp *s, int32_t q_dx, const int32_t e_q18[2],
                         const int32_t f[2], int32_t wide)
{
    uint32_t most = qtri_small_abs((int32_t)s->dx);
    for (int i = 0; i < 2; i++) {
        const int32_t at_vertex = (int32_t)s->dx - (f[i] * (q_dx >> 6) >> (6 - wide));
        const uint32_t slope = qtri_small_abs((at_vertex >> 10) * (1024 + (e_q18[i] >> 8))) + 1024;
        most = slope > most ? slope : most;
    }
    return most;
}

/* Whether parabolas over 2^log2 columns are near enough to a value of this slope, in units of
   2^unit_log2 of s: where they have pixels of the triangle, the middle of q is half its rise below
   the least at most. */
static bool is_near_parabola(uint32_t slope, int32_t unit_log2, uint32_t q_dx, uint32_t q_least_q10,
                             uint32_t log2, uint32_t by)
{
    const uint32_t q_rise = (q_dx >> (14 - log2)) + 1; /* Q10 */
    if (q_rise > 256 || slope >> (28 - log2) != 0) {
        return false;
    }
    const uint32_t q = q_least_q10 - q_rise / 2, q2 = q * q >> 10;
    qtri_curvature c;
    c.ratio_q12 = (q_rise * q_rise >> 8) + 1;
    c.q_mid2_q10 = 35 * (q2 * q2 >> 10) >> 5;
    return qtri_small_is_near_curve(&c, (slope << log2 >> unit_log2) + 1, by);
}

bool qtri_small_begin_division(qtri_small_division *d, uint32_t *piece, const qtri_curvature *c,
                               const qtri_small_place *p)
{
    const int32_t leftmost = qtri_small_min0(p->dx1, p->dx2);
    const uint32_t width = (uint32_t)(qtri_small_max0(p->dx1, p->dx2) - leftmost) >> 8;
    QTRI_SMALL_SETUP(ramp_set_at)
    (&d->q, p, p->x, p->y, 0, c->e_q18[0] >> 2, c->e_q18[1] >> 2, 0);
    d->goes_on = 0;
    d->left = leftmost >> 8;
    d->piece = piece;
    d->count = 0;
    d->spans = p->span;
    d->log2 = MOST_LOG2;
    while (d->log2 > LEAST_LOG2 && width >> (d->log2 - 1) == 0) {
        d->log2--;
    }
    /* no needle, and not too steep for all */
    return p->up == 0 && qtri_small_abs((int32_t)d->q.dx) >> 20 == 0;
}

bool qtri_small_add_divided(qtri_small_division *d, qtri_small_curve *curve,
                            const qtri_small_value *value, const qtri_curvature *c,
                            const qtri_small_place *p)
{
    qtri_small_divided *a = &d->a[d->count++];
    const int32_t *e = c->e_q18;
    const int32_t q_dx = (int32_t)d->q.dx, unit_log2 = value->unit_log2 + FRACTION;
    const uint32_t q_least = 1024u + (uint32_t)(qtri_small_min0(e[0], e[1]) >> 8);
    const int32_t f[2] = {(value->f1 + p->wide) >> p->wide, (value->f2 + p->wide) >> p->wide};
    QTRI_SMALL_SETUP(ramp_set_at)
    (&a->s, p, p->x, p->y, 0, qtri_small_scaled(f[0], e[0]), qtri_small_scaled(f[1], e[1]),
     FRACTION + p->wide);
    if (value->bend != 0) {
        *d->piece = 1; /* until it is known */
    }
    a->curve = curve;
    a->value = value->value;
    a->bend = value->bend;
    a->up = (int8_t)(value->up - FRACTION);
    const uint32_t slope = slope_of(&a->s, q_dx, e, f, p->wide);
    if (unit_log2 < 0 || (a->bend == 0 && slope >> unit_log2 > MOST_TEXELS * 64)) {
        return false;
    }
    while (!is_near_parabola(slope, unit_log2, qtri_small_abs(q_dx), q_least, d->log2, value->by)) {
        if (d->log2 == LEAST_LOG2) {
            return false;
        }
        d->log2--;
    }
    return true;
}

void qtri_small_end_division(qtri_small_division *d)
{
    const int32_t log2 = (int32_t)d->log2;
    for (qtri_small_divided *a = d->a; a != d->a + d->count; a++) {
        if (a->bend != 0) {
            d->left &= -(1 << CHORD_LOG2);
        }
        qtri_set_shifts(&a->at_left, &a->at_right, a->up);
        qtri_set_shifts(&a->step_left, &a->step_right, a->up - log2);
        qtri_set_shifts(&a->bend_left, &a->bend_right, a->up + 1 - 2 * log2);
    }
}

/* A ramp at column x, from vertex 0's, `row` rows below the triangle's first. */
static uint32_t ramp_at(const qtri_small_ramp *r, uint32_t x, uint32_t row)
{
    return r->at + x * r->dx + row * r->dy;
}

/* 1 / (1 + q) at a point, Q16. */
static int32_t reciprocal_at(const qtri_small_division *d, uint32_t x, uint32_t row)
{
    const int32_t q = (int32_t)ramp_at(&d->q, x, row);
    return reciprocal_of(0x8000u + (uint32_t)(q >> 9));
}

/* A value less that of vertex 0, f = s / (1 + q), at that point; reciprocal: 1 / (1 + q), Q16. */
static inline int32_t difference_at(const qtri_small_divided *a, int32_t reciprocal, uint32_t x,
                                    uint32_t row)
{
    const int32_t s = (int32_t)ramp_at(&a->s, x, row);
    return s + qtri_small_product(s, (reciprocal - 0x10000) >> 1, 15);
}

/* Sets the curve from the point at column x to the next, at which the value is `to` more than at
   vertex 0; the middle is above the chord by `rise` eps / 2. */
static inline void set_parabola(qtri_small_divided *a, int32_t to, int32_t eps, uint32_t x)
{
    qtri_small_curve *c = a->curve;
    const int32_t from = a->point, rise = to - from;
    const int32_t w = qtri_small_product(rise, eps, 15);
    c->xx = 0u - qtri_both_shifts(w, a->bend_left, a->bend_right);
    c->dx = qtri_both_shifts(rise + 2 * w, a->step_left, a->step_right) - 2 * x * c->xx;
    c->at = a->value + qtri_both_shifts(from, a->at_left, a->at_right) - x * (c->dx + x * c->xx);
    a->point = to;
}

uint32_t qtri_small_divide(qtri_small_division *d, uint32_t x, uint32_t end, uint8_t *span)
{
    const uint32_t count = (uint32_t)1 << d->log2;
    const uint32_t row = (uint32_t)(span - d->spans) >> 1;
    qtri_small_divided *const last = d->a + d->count;
    int32_t chord_log2 = qtri_least32(CHORD_LOG2, (int32_t)d->log2);
    x -= QTRI_SMALL_REACH;
    if (!d->goes_on) {
        x -= (x - (uint32_t)d->left) & (count - 1);
        d->reciprocal = reciprocal_at(d, x, row);
        for (qtri_small_divided *a = d->a; a != last; a++) {
            a->point = difference_at(a, d->reciprocal, x, row);
        }
    }
    const int32_t reciprocal = reciprocal_at(d, x + count, row);
    const int32_t half = (int32_t)(d->q.dx << d->log2) >> 10; /* Q15, below 2^12 */
    int32_t eps = (half * ((reciprocal + d->reciprocal) >> 1)) >> 16;
    eps -= (eps * eps >> 15) * eps >> 15; /* the mean of reciprocals is 1 + eps^2 too much */
    d->reciprocal = reciprocal;
    for (qtri_small_divided *a = d->a; a != last; a++) {
        set_parabola(a, difference_at(a, reciprocal, x + count, row), eps, x);
        if (a->bend != 0) {
            chord_log2 = qtri_small_chord_log2(a->curve, chord_log2, a->bend);
            *d->piece = (uint32_t)1 << chord_log2;
        }
    }
    x += count + QTRI_SMALL_REACH;
    d->goes_on = x < end;
    if (x < end) {
        *span = (uint8_t)x;
        end = x;
    }
    return end;
}
