/* SPDX-License-Identifier: MIT */
/*
 * Values that follow perspective over a small triangle, as polynomials of second order. Internal.
 *
 * With e, what q has more than at vertex 0 by its value there, a value along the edge from there is
 * u_0 + f s (1 + e) / (1 + e s), s from 0 to 1: f s + f k s (1 - s), k = e / (1 + e/2), is equal at
 * both ends and in the middle. Over the triangle that is the product of what is linear,
 *
 *     u_0 + G - F E,   F = 0, f_1, f_2,   E = 0, k_1, k_2,   G = F (1 + E) at the vertices,
 *
 * which on the third edge has k_2 - k_1 in place of (e_2 - e_1) / (1 + (e_1 + e_2) / 2). With q_mid
 * the middle of the least and the greatest q, it strays by .0481 range(u) (range(q) / q_mid)^2 for
 * small e, .0481 being the maximum of s (1/2 - s) (1 - s), and by .056 of that for e of -1/4 to 1/2
 * at most, found by search: 2/35 is allowed for.
 */
#ifndef QTRI_RASTER_SMALL_CURVES_H
#define QTRI_RASTER_SMALL_CURVES_H

#include "qtri/body/small_setup.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What all curves of a triangle share. */
typedef struct qtri_curvature {
    int32_t e_q18[2], k_q18[2];
    int32_t e, ex, ey;   /* E at the pixel of vertex 0, and its steps, below 2^13.1 */
    int32_t bits;        /* of their fractions, 17 or more */
    uint32_t ratio_q12;  /* (range(q) / q_0)^2 */
    uint32_t q_mid2_q10; /* (q_mid / q_0)^2 times 35/32, below 2^10.8 */
} qtri_curvature;

/* False: E changes too much from pixel to pixel, over a triangle of hardly any width. */
bool qtri_small_set_curvature(qtri_curvature *c, const qtri_small_place *p, const qtri_small *t);
/* Whether a curve is off by 2/35 range (range(q) / q_mid)^2 <= 2^(by - 4) at most, by <= 18. */
bool qtri_small_is_near_curve(const qtri_curvature *c, uint32_t range, uint32_t by);

/* A value that varies, and how near a curve or a division has to be. */
typedef struct qtri_small_value {
    uint32_t value;    /* at vertex 0 */
    int32_t f1, f2;    /* what vertices 1 and 2 have more, */
    int32_t up;        /*   in units of 2^(8 + up) of it */
    uint32_t by;       /* see qtri_small_is_near_curve(), */
    int32_t unit_log2; /*   whose range is then in units of 2^(unit_log2 - 8) of f */
    uint32_t bend;     /* of light and colours: the most along a chord of a pixel; else 0 */
} qtri_small_value;

void qtri_small_set_curve(qtri_small_curve *r, const qtri_small_place *p, const qtri_curvature *c,
                          const qtri_small_value *value);

/* log2 of the pixels that a chord may have, `most` or less: over n pixels it is off by n^2 / 4 of
   xx, which is to be a quarter of `bend` at most. */
int32_t qtri_small_chord_log2(const qtri_small_curve *c, int32_t most, uint32_t bend);

/* In small_values.c: light between the vertices, and along a curve. */
void qtri_small_find_light(qtri_small_value *light, const qtri_small *t, const qtri_options *o);
void qtri_small_set_light_along(qtri_small_curves *curves, const qtri_curvature *c,
                                const qtri_small_place *p, const qtri_small_value *light);

/* Curves then hold for the whole triangle, without qtri_small_divide(). */
static inline void qtri_small_disable_division(qtri_small_division *d)
{
    d->log2 = 0;
    d->goes_on = 0;
}

/* In small_division.c, to be called in order: begin, with where to store the pixels of chords; a
   call for each value, whose curve qtri_small_divide() sets; end. False: the triangle bends too
   much. */
bool qtri_small_begin_division(qtri_small_division *d, uint32_t *piece, const qtri_curvature *c,
                               const qtri_small_place *p);
bool qtri_small_add_divided(qtri_small_division *d, qtri_small_curve *curve,
                            const qtri_small_value *value, const qtri_curvature *c,
                            const qtri_small_place *p);
void qtri_small_end_division(qtri_small_division *d);

/* 1/w at vertices 1 and 2 less that at vertex 0, divided by the latter. */
void qtri_small_find_inv_w_deltas(int32_t e_q18[2], const qtri_small_place *p, const qtri_small *t);

/* f (1 + e), |f| <= 2^16, |e| <= 1/2. */
QTRI_BODY int32_t qtri_small_scaled(int32_t f, int32_t e_q18)
{
    return f + (((f >> 2) * e_q18 + ((int32_t)1 << 15)) >> 16);
}

/* a b / 2^down, rounded; |a| < 2^30.2, |b| < 2^13.6 with 14 for `down`, 2^14.4 with 15. */
QTRI_BODY int32_t qtri_small_product(int32_t a, int32_t b, int down)
{
    const int32_t half = (int32_t)1 << (down - 1);
#if QTRI_LONG_MULTIPLY
    return (int32_t)(((int64_t)a * b + half) >> down);
#else
    return (a >> 16) * b * (1 << (16 - down)) +
           (((int32_t)qtri_low16((uint32_t)a) * b + half) >> down);
#endif
}

#ifdef __cplusplus
}
#endif

#endif
