/* SPDX-License-Identifier: MIT */
#include "polygon.h"

#include <math.h>
#include <stdlib.h>

#include "xalloc.h"

/* Corners are rounded to a grid of up to 2^29 steps a side: every cross product is exact in 64
 * bits. */
#define GRID_BITS 29

struct corner {
    int64_t x, y;
    uint32_t previous, next;
};

/* Twice the area of a triangle, above 0 where it turns left. |result| <= 2^59. */
static int64_t area(const struct corner *a, const struct corner *b, const struct corner *c)
{
    return (b->x - a->x) * (c->y - a->y) - (b->y - a->y) * (c->x - a->x);
}

static bool equal(const struct corner *a, const struct corner *b)
{
    return a->x == b->x && a->y == b->y;
}

/* The axis along which the polygon shows most of its area: the largest part of its normal (Newell).
 */
static int widest_view(const double (*p)[3], size_t count)
{
    double normal[3] = {0.0, 0.0, 0.0};
    for (size_t i = 1; i + 1 < count; i++) {
        for (int axis = 0; axis < 3; axis++) {
            const int u = (axis + 1) % 3, v = (axis + 2) % 3;
            normal[axis] += (p[i][u] - p[0][u]) * (p[i + 1][v] - p[0][v]) -
                            (p[i][v] - p[0][v]) * (p[i + 1][u] - p[0][u]);
        }
    }
    int widest = 0;
    for (int axis = 1; axis < 3; axis++) {
        widest = fabs(normal[axis]) > fabs(normal[widest]) ? axis : widest;
    }
    return widest;
}

/* False: the polygon is a point, or its size is not finite. */
static bool project(const double (*p)[3], size_t count, struct corner *ring)
{
    const int axis = widest_view(p, count), u = (axis + 1) % 3, v = (axis + 2) % 3;
    double low[2] = {p[0][u], p[0][v]}, high[2] = {p[0][u], p[0][v]};
    for (size_t i = 1; i < count; i++) {
        low[0] = fmin(low[0], p[i][u]);
        low[1] = fmin(low[1], p[i][v]);
        high[0] = fmax(high[0], p[i][u]);
        high[1] = fmax(high[1], p[i][v]);
    }
    const double side = fmax(high[0] - low[0], high[1] - low[1]);
    if (!(side > 0.0 && side < HUGE_VAL)) {
        return false;
    }
    int bits; /* side < 2^bits */
    (void)frexp(side, &bits);
    for (size_t i = 0; i < count; i++) {
        ring[i].x = (int64_t)ldexp(p[i][u] - low[0], GRID_BITS - bits);
        ring[i].y = (int64_t)ldexp(p[i][v] - low[1], GRID_BITS - bits);
        ring[i].previous = (uint32_t)(i == 0 ? count - 1 : i - 1);
        ring[i].next = (uint32_t)(i + 1 == count ? 0 : i + 1);
    }
    return true;
}

/*
 * A fan without a triangle that is turned over covers a polygon once, concave or not. Less than
 * 1/65536 of the area, by which numbers of six digits are off, does not count. Turns the ring so
 * that its area is not negative.
 */
static bool is_fan(struct corner *ring, size_t count)
{
    double sum = 0.0, least = 0.0, most = 0.0; /* of many corners sums exceed 64 bits */
    for (size_t i = 1; i + 1 < count; i++) {
        const double part = (double)area(&ring[0], &ring[i], &ring[i + 1]);
        sum += part;
        least = fmin(least, part);
        most = fmax(most, part);
    }
    for (size_t i = 0; sum < 0.0 && i < count; i++) {
        ring[i].x = -ring[i].x;
    }
    return fmax(sum < 0.0 ? most : -least, 0.0) * 65536.0 <= fabs(sum) || sum == 0.0;
}

/* The triangle turns left, and no other corner lies in it. Corners at the same position as its own,
   as where an edge to a hole goes there and back, do not count. */
static bool is_ear(const struct corner *ring, const struct corner *tip)
{
    const struct corner *a = &ring[tip->previous], *c = &ring[tip->next];
    bool is_free = area(a, tip, c) > 0;
    for (const struct corner *p = &ring[c->next]; is_free && p != a; p = &ring[p->next]) {
        is_free = equal(p, a) || equal(p, tip) || equal(p, c) || area(a, tip, p) < 0 ||
                  area(tip, c, p) < 0 || area(c, a, p) < 0;
    }
    return is_free;
}

/* Where no ear is left, as of polygons that cross themselves, a corner that turns left goes, or
 * any. */
static void clip_ears(struct corner *ring, size_t count, uint32_t (*triangles)[3])
{
    struct corner *tip = ring;
    for (size_t left = count, tried = 0; left >= 3;) {
        struct corner *next = &ring[tip->next];
        if (is_ear(ring, tip) || tried == left) {
            uint32_t *triangle = triangles[count - left--];
            triangle[0] = tip->previous;
            triangle[1] = (uint32_t)(tip - ring);
            triangle[2] = tip->next;
            ring[tip->previous].next = tip->next;
            next->previous = tip->previous;
            next = &ring[next->next]; /* else thin triangles gather about one corner */
            tried = 0;
        } else {
            tried++;
        }
        tip = next;
    }
}

void polygon_triangulate(const double (*corners)[3], size_t count, uint32_t (*triangles)[3])
{
    for (size_t i = 0; i + 2 < count; i++) {
        triangles[i][0] = 0;
        triangles[i][1] = (uint32_t)(i + 1);
        triangles[i][2] = (uint32_t)(i + 2);
    }
    if (count == 3) {
        return;
    }
    struct corner *ring = xcalloc(count, sizeof *ring);
    if (project(corners, count, ring) && !is_fan(ring, count)) {
        clip_ears(ring, count, triangles);
    }
    free(ring);
}
