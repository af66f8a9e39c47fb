/* SPDX-License-Identifier: MIT */
/*
 * Triangles whose vertices are snapped to a grid of 2^-N pixels: what an ideal fixed-point
 * renderer with N sub-pixel bits draws. Coverage is decided in integers, without any rounding.
 */
#include "raster.h"
#include "clip.h"
#include "snap.h"
#include "texture.h"

#include <math.h>

struct snapped_vertex {
    int64_t x, y; /* 2^-N pixels */
    double depth; /* window depth */
    double w;
    const struct ref_vertex *source;
};

struct integer_edge {
    int64_t a, b;      /* |a|, |b| <= 2^30 */
    int64_t origin[2]; /* value at (X, Y): a (X - origin[0]) + b (Y - origin[1]), below 2^62 */
    bool owns_border;
};

/* Twice the area of (p, q, r), positive if they are clockwise in the picture. */
static int64_t doubled_area(const struct snapped_vertex *p, const struct snapped_vertex *q,
                            const struct snapped_vertex *r)
{
    return (q->x - p->x) * (r->y - p->y) - (q->y - p->y) * (r->x - p->x);
}

/* Edge function of p to q, positive inside a triangle whose doubled area has the sign `sign`. */
static struct integer_edge edge_between(const struct snapped_vertex *p,
                                        const struct snapped_vertex *q, int sign)
{
    struct integer_edge e;

    e.a = sign * (p->y - q->y);
    e.b = sign * (q->x - p->x);
    e.origin[0] = p->x;
    e.origin[1] = p->y;
    e.owns_border = e.a > 0 || (e.a == 0 && e.b > 0);
    return e;
}

/* `offset` pixels from its centre, to the grid. */
static int64_t place(int pixel, int bits, double offset)
{
    return ((int64_t)pixel << bits) + ((int64_t)1 << (bits - 1)) + llround(ldexp(offset, bits));
}

static struct ref_box bounds(const struct snapped_vertex *const v[3], int bits, int width,
                             int height)
{
    int64_t x_min = v[0]->x, x_max = v[0]->x, y_min = v[0]->y, y_max = v[0]->y;

    for (int i = 1; i < 3; i++) {
        x_min = v[i]->x < x_min ? v[i]->x : x_min;
        x_max = v[i]->x > x_max ? v[i]->x : x_max;
        y_min = v[i]->y < y_min ? v[i]->y : y_min;
        y_max = v[i]->y > y_max ? v[i]->y : y_max;
    }
    struct ref_box box = {
        ref_clamped_floor(ldexpl((long double)x_min, -bits), width),
        ref_clamped_floor(ldexpl((long double)y_min, -bits), height),
        ref_clamped_floor(ldexpl((long double)x_max, -bits) + 1, width),
        ref_clamped_floor(ldexpl((long double)y_max, -bits) + 1, height),
    };
    return box;
}

/* What the vertices count at the pixel: on the screen, or divided by w in the triangle's plane. */
static double footprint_of(const struct ref_target *target, const struct snapped_vertex *const v[3],
                           const struct integer_edge edge[3], const int64_t value[3])
{
    const struct ref_vertex *const source[3] = {v[0]->source, v[1]->source, v[2]->source};
    double weight[3], right[3], down[3];
    double pixel = ldexp(1.0, target->subpixel_bits);

    for (int i = 0; i < 3; i++) {
        double factor = target->scene->screen_linear ? 1.0 : 1.0 / v[i]->w;
        weight[i] = (double)value[i] * factor;
        right[i] = (double)edge[i].a * pixel * factor;
        down[i] = (double)edge[i].b * pixel * factor;
    }
    return ref_footprint(target->scene, source, weight, right, down) * target->at.scale;
}

/* The edge functions at a point of the grid; whether it is covered. */
static bool values_at(const struct integer_edge edge[3], int64_t x, int64_t y, int64_t value[3])
{
    bool covered = true;

    for (int i = 0; i < 3; i++) {
        const struct integer_edge *e = &edge[i];
        value[i] = e->a * (x - e->origin[0]) + e->b * (y - e->origin[1]);
        covered = covered && (value[i] > 0 || (value[i] == 0 && e->owns_border));
    }
    return covered;
}

/* Where a pixel is shaded of which a sample is covered: its centre, or the first sample that is
   covered. */
static void shading_values(const struct ref_target *target, const struct integer_edge edge[3],
                           int x, int y, int64_t value[3])
{
    const struct ref_sampling *at = &target->at;
    int bits = target->subpixel_bits;
    bool covered = values_at(edge, place(x, bits, 0.0), place(y, bits, 0.0), value);

    for (int i = 0; i < at->sample_count && !covered; i++)
        covered = values_at(edge, place(x, bits, at->samples[i][0]),
                            place(y, bits, at->samples[i][1]), value);
}

static void fragment(struct ref_target *target, const struct ref_triangle *triangle,
                     const struct snapped_vertex *const v[3], const struct integer_edge edge[3],
                     int x, int y, int64_t value[3], double area, double shift)
{
    double b0 = (double)value[0] / area; /* weights on the screen */
    double b1 = (double)value[1] / area;
    double b2 = (double)value[2] / area;
    double depth =
        v[0]->depth + b1 * (v[1]->depth - v[0]->depth) + b2 * (v[2]->depth - v[0]->depth);

    depth += shift;
    if (!ref_target_cover(target, x, y, depth))
        return;
    if (target->at.shades_pixels) {
        shading_values(target, edge, x, y, value);
        b0 = (double)value[0] / area;
        b1 = (double)value[1] / area;
        b2 = (double)value[2] / area;
    }
    if (!target->scene->screen_linear) {
        /* weights in the triangle's plane: proportional to b_i / w_i */
        double sum = b0 / v[0]->w + b1 / v[1]->w + b2 / v[2]->w;
        b1 = b1 / v[1]->w / sum;
        b2 = b2 / v[2]->w / sum;
    }
    const struct ref_vertex *const source[3] = {v[0]->source, v[1]->source, v[2]->source};
    double attribute[REF_ATTRIBUTES];
    ref_interpolate(source, b1, b2, attribute);
    ref_target_shade(target, x, y, depth, triangle, attribute,
                     footprint_of(target, v, edge, value));
}

/* What the slope of the triangle moves its depths by. */
static double shift_of(const struct ref_target *target, const struct snapped_vertex *const v[3],
                       const struct integer_edge edge[3], double area)
{
    double pixel = ldexp(1.0, target->subpixel_bits);
    double right = 0, down = 0, nearest = 1, farthest = 0;

    for (int i = 0; i < 3; i++) {
        right += (double)edge[i].a * pixel / area * v[i]->depth;
        down += (double)edge[i].b * pixel / area * v[i]->depth;
        nearest = fmin(nearest, v[i]->depth);
        farthest = fmax(farthest, v[i]->depth);
    }
    return ref_target_shift(target, right, down, nearest, farthest);
}

static void scan(struct ref_target *target, const struct ref_triangle *triangle,
                 const struct snapped_vertex *const v[3], int sign)
{
    int bits = target->subpixel_bits;
    struct ref_box box = bounds(v, bits, target->scene->width, target->scene->height);
    struct integer_edge edge[3] = {
        edge_between(v[1], v[2], sign),
        edge_between(v[2], v[0], sign),
        edge_between(v[0], v[1], sign),
    };
    double area = (double)(sign * doubled_area(v[0], v[1], v[2]));
    double shift = shift_of(target, v, edge, area);

    for (int y = box.y_low; y < box.y_high; y++) {
        for (int x = box.x_low; x < box.x_high; x++) {
            int64_t value[3];
            if (values_at(edge, place(x, bits, target->at.x), place(y, bits, target->at.y), value))
                fragment(target, triangle, v, edge, x, y, value, area, shift);
        }
    }
}

static void snap_vertex(const struct ref_target *target, const struct ref_vertex *vertex,
                        struct snapped_vertex *out)
{
    int bits = target->subpixel_bits;

    out->x = ref_snap(ref_window_x(vertex, &target->window) / vertex->w, bits);
    out->y = ref_snap(ref_window_y(vertex, &target->window) / vertex->w, bits);
    out->depth = ref_target_depth(target, vertex->z / vertex->w);
    out->w = (double)vertex->w;
    out->source = vertex;
}

static int sign_of(int64_t v)
{
    return (v > 0) - (v < 0);
}

void ref_raster_snapped(struct ref_target *target, const struct ref_triangle *triangle)
{
    struct ref_polygon polygon;
    struct snapped_vertex snapped[REF_CLIP_MAX_COUNT];
    int64_t total = 0;

    if (ref_clip_all_outside(triangle->vertex))
        return;
    ref_clip_triangle(triangle->vertex, &target->window, ref_guard_band(target->subpixel_bits),
                      &polygon);
    for (int i = 0; i < polygon.count; i++)
        snap_vertex(target, &polygon.vertex[i], &snapped[i]);
    for (int i = 2; i < polygon.count; i++)
        total += doubled_area(&snapped[0], &snapped[i - 1], &snapped[i]);
    int sign = sign_of(total);
    if (!ref_facing_is_drawn(target, -sign)) /* clockwise is the back */
        return;
    for (int i = 2; i < polygon.count; i++) {
        const struct snapped_vertex *const fan[3] = {&snapped[0], &snapped[i - 1], &snapped[i]};
        /* Snapping may dent a clipped polygon; the sliver of the fan that turned over lies on
           pixels its neighbour in the fan covers, and is left out. */
        if (sign_of(doubled_area(fan[0], fan[1], fan[2])) == sign)
            scan(target, triangle, fan, sign);
    }
}
