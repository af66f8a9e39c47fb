/* SPDX-License-Identifier: MIT */
/*
 * Barycentric shares of a triangle's vertices in double precision.
 */
#ifndef QTRI_TESTS_SUPPORT_SHARES_H
#define QTRI_TESTS_SUPPORT_SHARES_H

#include <math.h>
#include <stdbool.h>

#include <qtri.h>

/* At a place of 1/256 pixel: of the screen, or with perspective of the triangle. */
static inline void shares_at_place(double b[3], const qtri_screen_vertex v[3], double x_24p8,
                                   double y_24p8, bool perspective)
{
    double sum = 0;
    for (int i = 0; i < 3; i++) {
        const qtri_screen_vertex *p = &v[(i + 1) % 3], *q = &v[(i + 2) % 3];
        b[i] = (double)(q->x_24p8 - p->x_24p8) * (y_24p8 - p->y_24p8) -
               (double)(q->y_24p8 - p->y_24p8) * (x_24p8 - p->x_24p8);
        b[i] *= perspective ? ldexp(v[i].inv_w_q31, v[i].inv_w_exponent) : 1;
        sum += b[i];
    }
    for (int i = 0; i < 3; i++) {
        b[i] /= sum;
    }
}

/* At a pixel's centre. */
static inline void shares_at(double b[3], const qtri_screen_vertex v[3], int32_t x, int32_t y,
                             bool perspective)
{
    shares_at_place(b, v, x * 256 + 128, y * 256 + 128, perspective);
}

#endif
