/* SPDX-License-Identifier: MIT */
#include "near.h"

#include "list_values.h"

/*
 * Curves along a row. With the names of list_values.h an attribute is u = u_0 + l / (1 + e), where
 * l and e are linear on the screen. At pixel m, with k = 1 / (1 + e),
 *
 *     u = u_0 + l k,   slope L = l_x k - l k e',   e' = e_x k
 *
 * and d pixels from there, perspective.c says why, u + L (d - e' d^2 + ...). A block reaches h
 * pixels to both sides of m; 3/4 E^2 with E = e' h stands in for the cubic term, so that what is
 * left of it is L h E^2 / 4. Blocks have 32 pixels where |e_x| is below 1/768, 16 where it is below
 * 1/248: with k < 1.085 that is 1/420 of L and 1/400 of L. Steeper triangles go another way.
 */
/* The middle of a block. */
typedef struct middle {
    uint32_t x, y; /* from the base */
    int32_t half;  /* pixels before it: h, 0..16 */
    int32_t w;     /* 1 - k, Q16 */
    int32_t e_q23; /* e' */
    int32_t arc;   /* 3/4 E^2, Q16 */
} middle;

static void set_middle(middle *m, const qtri_list_values *v, uint32_t x, uint32_t y, int32_t half)
{
    m->x = x + (uint32_t)half;
    m->y = y;
    m->half = half;
    m->w = qtri_list_w(&v->e_q26, m->x, m->y);
    m->e_q23 = qtri_list_divided((int32_t)v->e_q26.dx, m->w) >> 3; /* < 2^15.3 */
    const int32_t reach = (m->e_q23 * half) >> 7;                  /* < 2^11.3, Q16 */
    m->arc = (reach * reach) >> 16;
    m->arc -= m->arc >> 2;
}

/*
 * The middle is a pixel of the triangle, so |l| <= 2^24.1, and since the longest row has 12 pixels
 * or more, see rows_are_long, |l_x| is below 2^20.6.
 */
static void set_curve(qtri_curve *out, const middle *m, const qtri_ramp *l, uint32_t base,
                      int32_t up)
{
    const int32_t half = m->half;
    const int32_t value = qtri_list_divided((int32_t)qtri_list_at(l, m->x, m->y), m->w);
    int32_t slope = qtri_list_divided((int32_t)l->dx, m->w) - (((value >> 9) * m->e_q23) >> 14);
    slope += ((slope >> 8) * m->arc) >> 8;
    const int32_t bend = -(((slope >> 5) * m->e_q23) >> 18); /* once: it counts twice */
    out->at = base + ((uint32_t)(value + (half * bend - slope) * half) << up);
    out->step = (uint32_t)(slope + (1 - 2 * half) * bend) << up;
    out->bend = (uint32_t)bend << (up + 1);
    out->twist = 0;
}

/* Curve i at a pixel, from the base. */
static void set_line(qtri_curve *out, const qtri_ramp *ramp, uint32_t x, uint32_t y)
{
    out->at = qtri_list_at(ramp, x, y);
    out->step = ramp->dx;
    out->bend = 0;
    out->twist = 0;
}

int32_t qtri_interpolate_near(qtri_scanline *row, int32_t x, int32_t count, int first, int end)
{
    const qtri_job *job = row->job;
    const qtri_list_values *v = job->values;
    const uint32_t column = (uint32_t)(x - job->anchor_x);
    const uint32_t line = (uint32_t)(row->y - job->anchor_y);
    middle m;
    if (first < QTRI_U && !v->curved) {
        for (int i = first; i < end; i++) {
            set_line(&row->curve[i], &v->channel[i], column, line);
        }
        return count;
    }
    count = qtri_least32(count, qtri_least32(v->block, row->right - x));
    set_middle(&m, v, column, line, count >> 1);
    for (int i = first; i < end; i++) {
        if (i < QTRI_U) {
            set_curve(&row->curve[i], &m, &v->channel[i], v->base[i], 0);
        } else {
            const qtri_list_axis *axis = &v->uv[i - QTRI_U];
            set_curve(&row->curve[i], &m, &axis->l, axis->at, axis->up);
        }
    }
    return count;
}
