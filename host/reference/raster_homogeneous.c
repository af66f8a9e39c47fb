/* SPDX-License-Identifier: MIT */
/*
 * Triangles of any w, without clipping and without snapping.
 *
 * With the vertices as columns of a matrix M of homogeneous window coordinates (X, Y, W), the
 * point of the triangle seen at (x, y) has weights b with M b = w (x, y, 1), that is
 * b / w = M^-1 (x, y, 1). The rows of the adjugate of M therefore are edge functions that hold for
 * every sign of w: the pixel is inside the triangle and in front of the eye exactly where all
 * three, divided by the determinant, are positive. (M. Olano and T. Greer, Triangle Scan
 * Conversion using 2D Homogeneous Coordinates, Graphics Hardware 1997.)
 */
#include "raster.h"
#include "clip.h"
#include "texture.h"

#include <math.h>

/* A fused multiply-add would round the two products of a difference differently, and the edge
   from a to b would no longer be exactly minus the edge from b to a. GCC does not fuse under
   -std=c99 and warns about the pragma. */
#ifdef __clang__
#pragma STDC FP_CONTRACT OFF
#endif

struct edge {
    long double a, b, c; /* inside: a x + b y + c > 0 */
    bool owns_border;    /* top or left edge */
};

struct window_point {
    long double x, y, w;
};

static struct edge edge_between(struct window_point p, struct window_point q)
{
    struct edge e = {
        p.y * q.w - p.w * q.y,
        p.w * q.x - p.x * q.w,
        p.x * q.y - p.y * q.x,
        false,
    };
    return e;
}

static void orient(struct edge *e, long double determinant)
{
    if (determinant < 0) {
        e->a = -e->a;
        e->b = -e->b;
        e->c = -e->c;
    }
    /* Rows go down: the inside is to the right of a left edge and below a top edge. */
    e->owns_border = e->a > 0 || (e->a == 0 && e->b > 0);
}

static long double determinant_of(const struct edge *e0, struct window_point p0)
{
    return p0.x * e0->a + p0.y * e0->b + p0.w * e0->c;
}

int ref_facing(const struct ref_triangle *triangle)
{
    struct window_point p[3];

    for (int i = 0; i < 3; i++) {
        const struct ref_vertex *v = &triangle->vertex[i];
        p[i] = (struct window_point){v->x, v->y, v->w};
    }
    struct edge e0 = edge_between(p[1], p[2]);
    long double determinant = determinant_of(&e0, p[0]);
    return (determinant > 0) - (determinant < 0);
}

bool ref_facing_is_drawn(const struct ref_target *target, int facing)
{
    switch (target->scene->cull) {
    case SCENE_CULL_BACK:
        return facing > 0;
    case SCENE_CULL_FRONT:
        return facing < 0;
    case SCENE_CULL_NONE:
        break;
    }
    return facing != 0;
}

int ref_clamped_floor(long double v, int limit)
{
    if (!(v > 0))
        return 0;
    return v < limit ? (int)v : limit;
}

/* Pixels the triangle can touch: all of them as soon as a vertex is not in front of the eye. */
static struct ref_box bounds(const struct window_point p[3], int width, int height)
{
    struct ref_box box = {0, 0, width, height};
    long double x_min = INFINITY, x_max = -INFINITY, y_min = INFINITY, y_max = -INFINITY;

    for (int i = 0; i < 3; i++) {
        if (p[i].w <= 0)
            return box;
        x_min = fminl(x_min, p[i].x / p[i].w);
        x_max = fmaxl(x_max, p[i].x / p[i].w);
        y_min = fminl(y_min, p[i].y / p[i].w);
        y_max = fmaxl(y_max, p[i].y / p[i].w);
    }
    /* one pixel more on each side than needed, against the rounding of the quotients */
    box.x_low = ref_clamped_floor(x_min - 1, width);
    box.y_low = ref_clamped_floor(y_min - 1, height);
    box.x_high = ref_clamped_floor(x_max + 2, width);
    box.y_high = ref_clamped_floor(y_max + 2, height);
    return box;
}

static bool inside(const struct edge *e, long double value)
{
    return value > 0 || (value == 0 && e->owns_border);
}

/* What the vertices count at the pixel, linear on the screen or in the triangle's plane. */
static double footprint_of(const struct ref_target *target,
                           const struct ref_vertex *const vertex[3], const struct edge edge[3],
                           const long double value[3])
{
    double weight[3], right[3], down[3];

    for (int i = 0; i < 3; i++) {
        double factor = target->scene->screen_linear ? (double)vertex[i]->w : 1.0;
        weight[i] = (double)value[i] * factor;
        right[i] = (double)edge[i].a * factor;
        down[i] = (double)edge[i].b * factor;
    }
    return ref_footprint(target->scene, vertex, weight, right, down) * target->at.scale;
}

/* The edge functions `x` and `y` away from the centre of a pixel; whether that is covered. */
static bool values_at(const struct edge edge[3], long double x, long double y, long double value[3])
{
    bool covered = true;

    for (int i = 0; i < 3; i++) {
        value[i] = edge[i].a * x + (edge[i].b * y + edge[i].c);
        covered = covered && inside(&edge[i], value[i]);
    }
    return covered;
}

/* Where a pixel is shaded of which a sample is covered: its centre, or the first sample that is
   covered. */
static void shading_values(const struct ref_sampling *at, const struct edge edge[3], int x, int y,
                           long double value[3])
{
    bool covered = values_at(edge, x + 0.5L, y + 0.5L, value);

    for (int i = 0; i < at->sample_count && !covered; i++)
        covered =
            values_at(edge, x + 0.5L + at->samples[i][0], y + 0.5L + at->samples[i][1], value);
}

/* `value` are the three edge functions at the pixel: b / w times the determinant's magnitude. */
static void fragment(struct ref_target *target, const struct ref_triangle *triangle,
                     const struct edge edge[3], int x, int y, long double value[3])
{
    const struct ref_vertex *v = triangle->vertex;
    const struct ref_vertex *const vertex[3] = {&v[0], &v[1], &v[2]};
    long double sum = 0, z = 0, w = 0, to_near = 0, to_far = 0;

    for (int i = 0; i < 3; i++) {
        sum += value[i];
        z += value[i] * v[i].z;
        w += value[i] * v[i].w;
        /* added up separately, so that vertices that lie on a plane cannot be rounded off it */
        to_near += value[i] * (v[i].w + v[i].z);
        to_far += value[i] * (v[i].w - v[i].z);
    }
    if (!(sum > 0 && w > 0 && to_near >= 0 && to_far >= 0))
        return;
    /* z / w is linear on the screen, and w the same everywhere. */
    double depth = ref_target_depth(target, z / w);
    double half = (target->depth_far - target->depth_near) / 2;
    double right = 0, down = 0;
    for (int i = 0; i < 3; i++) {
        right += (double)(edge[i].a * v[i].z / w) * half;
        down += (double)(edge[i].b * v[i].z / w) * half;
    }
    depth += ref_target_shift(target, right, down, depth, depth);
    if (!ref_target_cover(target, x, y, depth))
        return;
    if (target->at.shades_pixels) {
        shading_values(&target->at, edge, x, y, value);
        sum = value[0] + value[1] + value[2];
        w = value[0] * v[0].w + value[1] * v[1].w + value[2] * v[2].w;
    }

    double attribute[REF_ATTRIBUTES];
    double weight1 = (double)(value[1] / sum);
    double weight2 = (double)(value[2] / sum);
    if (target->scene->screen_linear) {
        /* weights of the projected triangle. Some are outside 0..1 where a w is not positive;
           colours are clamped when shaded. */
        weight1 = (double)(value[1] * v[1].w / w);
        weight2 = (double)(value[2] * v[2].w / w);
    }
    ref_interpolate(vertex, weight1, weight2, attribute);
    ref_target_shade(target, x, y, depth, triangle, attribute,
                     footprint_of(target, vertex, edge, value));
}

static void scan(struct ref_target *target, const struct ref_triangle *triangle,
                 const struct edge edge[3], const struct ref_box *box)
{
    for (int y = box->y_low; y < box->y_high; y++) {
        long double row[3];
        for (int i = 0; i < 3; i++)
            row[i] = edge[i].b * (y + 0.5L + target->at.y) + edge[i].c;
        for (int x = box->x_low; x < box->x_high; x++) {
            long double value[3];
            bool covered = true;
            for (int i = 0; i < 3 && covered; i++) {
                value[i] = edge[i].a * (x + 0.5L + target->at.x) + row[i];
                covered = inside(&edge[i], value[i]);
            }
            if (covered)
                fragment(target, triangle, edge, x, y, value);
        }
    }
}

void ref_raster_homogeneous(struct ref_target *target, const struct ref_triangle *triangle)
{
    int width = target->scene->width;
    int height = target->scene->height;
    struct window_point p[3];

    if (ref_clip_all_outside(triangle->vertex))
        return;
    for (int i = 0; i < 3; i++) {
        const struct ref_vertex *v = &triangle->vertex[i];
        p[i] = (struct window_point){ref_window_x(v, &target->window),
                                     ref_window_y(v, &target->window), v->w};
    }
    struct edge edge[3] = {
        edge_between(p[1], p[2]),
        edge_between(p[2], p[0]),
        edge_between(p[0], p[1]),
    };
    long double determinant = determinant_of(&edge[0], p[0]);
    if (determinant == 0 || !isfinite(determinant))
        return;
    /* rows go down: counter-clockwise in the picture is a negative determinant here */
    if (!ref_facing_is_drawn(target, determinant < 0 ? 1 : -1))
        return;
    for (int i = 0; i < 3; i++)
        orient(&edge[i], determinant);
    struct ref_box box = bounds(p, width, height);
    scan(target, triangle, edge, &box);
}
