/* SPDX-License-Identifier: MIT */
/*
 * Texture coordinates of small triangles by division, where they bend too much for a curve over the
 * whole triangle (small_curves.h).
 *
 * With q what 1/w has more than at vertex 0 by its value there, s = f (1 + q) is linear, f being
 * what a coordinate has more. At points n columns apart f = s / (1 + q) is found by a reciprocal.
 * Between two of them, `rise` apart, with eps = (q_2 - q_1) / (2 + q_1 + q_2), it is above the
 * chord by
 *
 *     rise eps / 2 (1 - z^2) / (1 + eps z), z from -1 to 1.
 *
 * A parabola through the points and the middle has 1 in place of the last divisor: it is off by
 * rise eps^2 / 2 times .385, the maximum of z (1 - z^2), or .0481 rise (q_2 - q_1)^2, and terms of
 * higher order; 2/35 is allowed for.
 *
 * Quads of 70 pixels turned by 30 degrees take 39 % less on a Cortex-M0+ and 26 % less on a
 * Cortex-M3 than as large triangles, the torus of 96 triangles (S13a) 11 and 8 %.
 *
 * Points count from the leftmost column of the triangle, so that what is drawn of it changes none.
 */
#include "small_curves.h"

#include "../bits/bits.h"

enum {
    FRACTION = 4,   /* bits that s has more than ramps of differences */
    LEAST_LOG2 = 3, /* of columns between points */
    MOST_LOG2 = 7,
    MOST_TEXELS = 4 /* a pixel: where there are more the snap of vertices shows */
};

/* 1 / (1 + q), Q16, of 1 + q in Q15 from 1/2 to 2. */
static inline int32_t reciprocal_of(uint32_t x)
{
    return (int32_t)(x >= 0x8000 ? qtri_small_reciprocal(x) : qtri_small_reciprocal(2 * x) << 1);
}

/* What a division needs to know of a coordinate: its steepest slope at q = 0, and log2 of 2^-6
   texel, in units of s. */
typedef struct steepness {
    uint32_t slope;
    int32_t texel_log2;
} steepness;

/* Of what is f more at vertices 1 and 2. The slope of f times (1 + q)^2, s' (1 + q) - s q', does
   not change along rows: it is steepest at a vertex. */
static uint32_t slope_of(const qtri_small_ramp *s, int32_t q_dx, const int32_t e_q18[2],
                         const int32_t f[2], int32_t wide)
{
    uint32_t most = qtri_small_about((int32_t)s->dx);
    for (int i = 0; i < 2; i++) {
        const int32_t at_vertex = (int32_t)s->dx - (f[i] * (q_dx >> 6) >> (6 - wide));
        const uint32_t slope =
            qtri_small_about((at_vertex >> 10) * (1024 + (e_q18[i] >> 8))) + 1024;
        most = slope > most ? slope : most;
    }
    return most;
}

/* Whether parabolas of 2^log2 columns are near enough: where they have pixels of the triangle, the
   middle of q is half its rise below the least at most. */
static bool is_near_parabola(const steepness s[2], uint32_t q_dx, uint32_t q_least_q10,
                             uint32_t log2, uint32_t by)
{
    const uint32_t q_rise = (q_dx >> (14 - log2)) + 1; /* Q10 */
    if (q_rise > 256) {
        return false;
    }
    const uint32_t q = q_least_q10 - q_rise / 2, q2 = q * q >> 10;
    qtri_curvature c;
    c.ratio_q12 = (q_rise * q_rise >> 8) + 1;
    c.q_mid2_q10 = 35 * (q2 * q2 >> 10) >> 5;
    for (int k = 0; k < 2; k++) {
        if (s[k].slope >> (28 - log2) != 0 ||
            !qtri_small_is_near_curve(&c, (s[k].slope << log2 >> s[k].texel_log2) + 1, by)) {
            return false;
        }
    }
    return true;
}

/* f (1 + q), of f more at vertices 1 and 2. */
static void set_product(qtri_small_ramp *s, const qtri_small_place *p, const int32_t e_q18[2],
                        const int32_t f[2])
{
    QTRI_SMALL_SETUP(ramp_set_at)
    (s, p, p->x, p->y, 0, qtri_small_scaled(f[0], e_q18[0]), qtri_small_scaled(f[1], e_q18[1]),
     FRACTION + p->wide);
}

bool qtri_small_set_division(qtri_small_curves *curves, const qtri_small_units *units,
                             const qtri_curvature *c, const qtri_small_place *p, int32_t f[2][3],
                             uint32_t by)
{
    qtri_small_division *d = &curves->division;
    const int32_t *e = c->e_q18;
    const int32_t leftmost = qtri_small_min(p->dx1, p->dx2);
    const uint32_t width = (uint32_t)(qtri_small_max(p->dx1, p->dx2) - leftmost) >> 8;
    const uint32_t q_least = 1024u + (uint32_t)(qtri_small_min(e[0], e[1]) >> 8);
    steepness s[2];
    QTRI_SMALL_SETUP(ramp_set_at)
    (&d->q, p, p->x, p->y, 0, e[0] >> 2, e[1] >> 2, 0);
    const int32_t q_dx = (int32_t)d->q.dx;
    if (p->up != 0 || qtri_small_about(q_dx) >> 19 != 0) { /* a needle; too steep for all */
        return false;
    }
    for (int k = 0; k < 2; k++) {
        const int32_t f_s[2] = {(f[k][1] + p->wide) >> p->wide, (f[k][2] + p->wide) >> p->wide};
        qtri_small_ramp *ramp = &d->a[k].s;
        set_product(ramp, p, e, f_s);
        s[k].slope = slope_of(ramp, q_dx, e, f_s, p->wide);
        s[k].texel_log2 = (int32_t)units->texel_log2[k] - (int32_t)units->up[k] + FRACTION - 6;
        if (s[k].texel_log2 < 0 || s[k].slope >> s[k].texel_log2 > MOST_TEXELS * 64) {
            return false;
        }
    }
    uint32_t log2 = MOST_LOG2;
    while (log2 > LEAST_LOG2 && width >> (log2 - 1) == 0) {
        log2--;
    }
    while (!is_near_parabola(s, qtri_small_about(q_dx), q_least, log2, by)) {
        if (log2 == LEAST_LOG2) {
            return false;
        }
        log2--;
    }
    d->log2 = log2;
    d->spans = p->span;
    d->left = leftmost >> 8;
    for (int k = 0; k < 2; k++) {
        qtri_small_divided *a = &d->a[k];
        const int32_t up = (int32_t)units->up[k] - FRACTION;
        a->value = units->base[k];
        qtri_set_shifts(&a->at_left, &a->at_right, up);
        qtri_set_shifts(&a->step_left, &a->step_right, up - (int32_t)log2);
        qtri_set_shifts(&a->bend_left, &a->bend_right, up + 1 - 2 * (int32_t)log2);
    }
    return true;
}

/* In a row so many below the first. */
static uint32_t ramp_at(const qtri_small_ramp *r, uint32_t x, uint32_t row)
{
    return r->at + x * r->dx + row * r->dy;
}

static void find_point(qtri_small_division *d, uint32_t x, uint32_t row)
{
    const int32_t q = (int32_t)ramp_at(&d->q, x, row);
    d->reciprocal = reciprocal_of(0x8000u + (uint32_t)(q >> 9));
    const int32_t r = (d->reciprocal - 0x10000) >> 1;
    const int32_t u = (int32_t)ramp_at(&d->a[0].s, x, row);
    d->a[0].point = u + qtri_small_product(u, r, 15);
    const int32_t v = (int32_t)ramp_at(&d->a[1].s, x, row);
    d->a[1].point = v + qtri_small_product(v, r, 15);
}

/* From a point at column x to the next, whose middle is above the chord by `rise` eps / 2. */
static inline void set_parabola(qtri_small_curve *c, const qtri_small_divided *a, int32_t from,
                                int32_t eps, uint32_t x)
{
    const int32_t rise = a->point - from;
    const int32_t w = qtri_small_product(rise, eps, 15);
    c->xx = 0u - qtri_both_shifts(w, a->bend_left, a->bend_right);
    c->dx = qtri_both_shifts(rise + 2 * w, a->step_left, a->step_right) - 2 * x * c->xx;
    c->at = a->value + qtri_both_shifts(from, a->at_left, a->at_right) - x * (c->dx + x * c->xx);
}

uint32_t qtri_small_divide(qtri_small_curves *curves, uint32_t x, uint32_t end, uint8_t *span)
{
    qtri_small_division *d = &curves->division;
    const uint32_t count = (uint32_t)1 << d->log2;
    const uint32_t row = (uint32_t)(span - d->spans) >> 1;
    x -= QTRI_SMALL_REACH;
    if (!d->goes_on) {
        x -= (x - (uint32_t)d->left) & (count - 1);
        find_point(d, x, row);
    }
    const int32_t u = d->a[0].point, v = d->a[1].point, reciprocal = d->reciprocal;
    find_point(d, x + count, row);
    const int32_t half = (int32_t)(d->q.dx << d->log2) >> 10; /* Q15, below 2^12 */
    int32_t eps = (half * ((reciprocal + d->reciprocal) >> 1)) >> 16;
    eps -= (eps * eps >> 15) * eps >> 15; /* the mean of reciprocals is 1 + eps^2 too much */
    set_parabola(&curves->u, &d->a[0], u, eps, x);
    set_parabola(&curves->v, &d->a[1], v, eps, x);
    x += count + QTRI_SMALL_REACH;
    d->goes_on = x < end;
    if (x < end) {
        *span = (uint8_t)x;
        end = x;
    }
    return end;
}
