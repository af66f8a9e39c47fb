/* SPDX-License-Identifier: MIT */
/*
 * Everything about a triangle that does not change from row to row. Internal.
 */
#ifndef QTRI_RASTER_SETUP_H
#define QTRI_RASTER_SETUP_H

#include "triangle.h"
#include "unsnapped.h"

/* Returns the function that fills the job's rows. */
qtri_fill_rows qtri_job_init(qtri_job *job, const qtri_raster *raster,
                             const qtri_triangle *triangle, const qtri_attributes v[3]);

/* The part of it for attributes that vary; job and gradient are set so far. */
qtri_fill_rows qtri_job_set_varying(qtri_job *job, const qtri_triangle *triangle,
                                    const qtri_attributes v[3], const qtri_gradient *gradient,
                                    const qtri_unsnapped *unsnapped);

/* Colour i of the three vertices: a channel, or their share of a tint. */
void qtri_job_color(uint32_t f[3], const qtri_job *job, const qtri_attributes v[3], int i);

/* 1/w with one exponent, the largest in 2^30..2^31. False when all are equal. */
static inline bool qtri_align_inv_w(uint32_t q[3], const qtri_attributes v[3])
{
    const int32_t greatest = qtri_greatest32(
        qtri_greatest32(v[0].inv_w_exponent, v[1].inv_w_exponent), v[2].inv_w_exponent);
    for (int i = 0; i < 3; i++) {
        const uint32_t down = (uint32_t)greatest - (uint32_t)v[i].inv_w_exponent; /* < 2^32 */
        q[i] = down > 29 ? 1 : v[i].inv_w_q31 >> down;
    }
    return q[0] != q[1] || q[0] != q[2];
}

/* Where the vertices are. */
static inline void qtri_gradient_place(qtri_gradient *g, const qtri_triangle *t)
{
    g->x_24p8 = t->p[0]->x_24p8;
    g->y_24p8 = t->p[0]->y_24p8;
    g->dx1 = t->p[1]->x_24p8 - g->x_24p8;
    g->dy1 = t->p[1]->y_24p8 - g->y_24p8;
    g->dx2 = t->p[2]->x_24p8 - g->x_24p8;
    g->dy2 = t->p[2]->y_24p8 - g->y_24p8;
    g->area = t->area;
}

static inline void qtri_gradient_set_anchor(qtri_gradient *g, int32_t x, int32_t y)
{
    g->anchor_x = x;
    g->anchor_y = y;
    g->anchor_dx = x * 256 + 128 - g->x_24p8;
    g->anchor_dy = y * 256 + 128 - g->y_24p8;
}

/* The middle of its bounds. */
static inline void qtri_gradient_set_middle(qtri_gradient *g, const qtri_triangle *t)
{
    qtri_gradient_set_anchor(g, (t->x_least + t->x_greatest) >> 9,
                             (t->top->y_24p8 + t->bottom->y_24p8) >> 9);
}

#endif
