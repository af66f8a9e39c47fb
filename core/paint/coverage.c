/* SPDX-License-Identifier: MIT */
#include "coverage.h"

/* An edge from left to right. */
typedef struct edge {
    int32_t x0, x1, height;
    int32_t zeros;       /* of x1 - x0, */
    uint32_t reciprocal; /*   and its reciprocal */
} edge;

/* height (x - x0) / (x1 - x0), rounded; x0 <= x <= x1. Monotone in x. */
static inline int32_t height_at(const edge *e, int32_t x)
{
    if (x == e->x1) {
        return e->height;
    }
    const uint32_t n = (uint32_t)(x - e->x0) << (e->zeros - 1); /* < 2^31 */
    const int32_t t_q21 = (int32_t)(qtri_mul_high31(n, e->reciprocal) >> 8);
    return (e->height * t_q21 + ((int32_t)1 << 20)) >> 21; /* |.| <= 2^29 + 2^20 */
}

void qtri_coverage_add_wide(qtri_coverage *w, int32_t x0, int32_t y0, int32_t x1, int32_t y1,
                            int32_t winding)
{
    const int32_t left = w->x * 256;
    const int32_t right = w->end * 256;
    const int32_t height = winding * (y1 - y0);
    if (x0 > x1) { /* from left to right */
        const int32_t x = x0;
        const int32_t y = y0;
        x0 = x1;
        y0 = y1;
        x1 = x;
        y1 = y;
        winding = -winding;
    }
    if (x0 >= right) {
        return;
    }
    if (x1 <= left) {
        w->sum[0] += height * 512;
        return;
    }
    /* x0 < x1: qtri_coverage_add() has added an edge within a column of the window. */
    edge e = {x0, x1, y1 - y0, qtri_clz32((uint32_t)(x1 - x0)), 0}; /* zeros >= 8 */
    e.reciprocal = qtri_reciprocal_near((uint32_t)(x1 - x0) << e.zeros);
    int32_t x = x0;
    int32_t done = 0; /* of the edge's height */
    if (x < left) {
        done = height_at(&e, left);
        w->sum[0] += winding * done * 512;
        x = left;
    }
    while (x < x1 && x < right) {
        const int32_t side = x & ~(int32_t)255;
        const int32_t to = qtri_least32(side + 256, x1);
        const int32_t upto = height_at(&e, to);
        qtri_coverage_add_piece(&w->sum[(side >> 8) - w->x], winding * (upto - done),
                                x + to - 2 * side);
        x = to;
        done = upto;
    }
}
