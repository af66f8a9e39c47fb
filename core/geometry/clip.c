/* SPDX-License-Identifier: MIT */
/* Outcodes, and clipping of polygons and lines in homogeneous coordinates. */
#include "qtri/error.h"
#include "qtri/view.h"

#include "../bits/bits.h"
#include "../bits/wide.h"

#define PLANES 6

/*
 * Distances to the planes, >= 0 inside, in the order of the outcode bits. |x| < 2^61 leaves
 * |z + w| < 2^62. The guard band divides x instead of multiplying w: it moves the plane by less
 * than one unit of w, which is far below the precision of any vertex.
 */
static int64_t distance(const qtri_clip_vertex *v, int plane)
{
    int64_t x = plane < 2 ? v->z : (plane < 4 ? v->x : v->y) >> QTRI_GUARD_LOG2;
    return (plane & 1) != 0 ? v->w - x : v->w + x;
}

unsigned qtri_clip_outcode(const qtri_clip_vertex *v)
{
    QTRI_ASSERT(v != NULL);
    unsigned outcode = 0;
    for (int plane = 0; plane < PLANES; plane++) {
        if (distance(v, plane) < 0) {
            outcode |= 1u << plane;
        }
    }
    /*
     * w <= 0 can only pass all with x = y = z = 0, give or take a unit: such a point cannot be
     * projected, so the near plane says no. Only then: a triangle outside one plane is dropped.
     */
    return outcode == 0 && v->w <= 0 ? QTRI_OUT_NEAR : outcode;
}

/* a + (b - a) t for |b - a| < 2^62 and t in [0, 1], truncated towards a. */
QTRI_NOINLINE static int64_t interpolate(int64_t a, int64_t b, int64_t t_q62)
{
    return a + qtri_mul_q62(b - a, t_q62);
}

/*
 * Where the edge from `inside` to `outside` meets the plane; *out may be either. Always from inside
 * to outside: both triangles at a shared edge do the same arithmetic and get the same bits. t has
 * 60 good bits: with 16 a cut at the near plane could be off by 17 pixels.
 */
static void cut(qtri_clip_vertex *out, const qtri_clip_vertex *inside,
                const qtri_clip_vertex *outside, int plane)
{
    qtri_wide t;
    qtri_wide whole;
    int64_t in = distance(inside, plane); /* in >= 0 > out: in - out < 2^63 */
    qtri_wide_set(&t, in, 0);
    qtri_wide_set(&whole, in - distance(outside, plane), 0);
    qtri_wide_div_by(&t, &whole);
    int64_t t_q62 = qtri_shift_round(t.m, t.e - 62); /* t < 1: e >= 62 */

    out->x = interpolate(inside->x, outside->x, t_q62);
    out->y = interpolate(inside->y, outside->y, t_q62);
    out->z = interpolate(inside->z, outside->z, t_q62);
    out->w = interpolate(inside->w, outside->w, t_q62);
    out->b1_q30 = (int32_t)interpolate(inside->b1_q30, outside->b1_q30, t_q62);
    out->b2_q30 = (int32_t)interpolate(inside->b2_q30, outside->b2_q30, t_q62);
}

/*
 * One step of Sutherland and Hodgman: a plane adds at most one vertex to a convex polygon. In
 * place: the polygon moves to the end of v, so that reading stays ahead of writing.
 */
static int clip_plane(qtri_clip_vertex v[QTRI_CLIP_MAX], int count, int plane)
{
    const int start = QTRI_CLIP_MAX - count;
    for (int i = QTRI_CLIP_MAX; i-- > start;) {
        v[i] = v[i - start];
    }
    const qtri_clip_vertex first = v[start];
    bool inside = distance(&first, plane) >= 0;
    int written = 0;
    for (int i = start; i < QTRI_CLIP_MAX; i++) {
        const qtri_clip_vertex *next = i + 1 < QTRI_CLIP_MAX ? &v[i + 1] : &first;
        bool next_inside = distance(next, plane) >= 0;
        qtri_clip_vertex *current = &v[i]; /* not overwritten before the cut: written <= i */
        if (inside) {
            v[written++] = *current;
        }
        if (inside != next_inside && written <= i) {
            cut(&v[written++], inside ? current : next, inside ? next : current, plane);
        }
        inside = next_inside;
    }
    return written;
}

int qtri_clip_polygon(qtri_clip_vertex v[QTRI_CLIP_MAX], int count, unsigned planes)
{
    QTRI_ASSERT(v != NULL);
    QTRI_ASSERT(count >= 0 && count <= 3);
    QTRI_ASSERT(planes < 2 * QTRI_OUT_BOTTOM);
    for (int plane = 0; plane < PLANES; plane++) {
        if (count > 0 && (planes & (1u << plane)) != 0) {
            count = clip_plane(v, count, plane);
        }
    }
    int kept = 0;
    for (int i = 0; i < count; i++) {
        if (v[i].w > 0) {
            v[kept++] = v[i]; /* kept <= i: safe in place */
        }
    }
    return kept < 3 ? 0 : kept;
}

int qtri_clip_line(qtri_clip_vertex v[2], unsigned planes)
{
    QTRI_ASSERT(v != NULL);
    QTRI_ASSERT(planes < 2 * QTRI_OUT_BOTTOM);
    for (int plane = 0; plane < PLANES; plane++) {
        if ((planes & (1u << plane)) == 0) {
            continue;
        }
        int first_inside = distance(&v[0], plane) >= 0;
        int second_inside = distance(&v[1], plane) >= 0;
        if (!first_inside && !second_inside) {
            return 0;
        }
        if (!first_inside) {
            cut(&v[0], &v[1], &v[0], plane);
        } else if (!second_inside) {
            cut(&v[1], &v[0], &v[1], plane);
        }
    }
    return v[0].w > 0 && v[1].w > 0;
}
