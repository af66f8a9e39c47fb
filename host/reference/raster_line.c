/* SPDX-License-Identifier: MIT */
/*
 * Lines one pixel wide: one pixel for every column (or row, if the line is steeper than 45
 * degrees) whose centre lies between the ends, the right end excluded.
 */
#include "raster.h"
#include "clip.h"
#include "snap.h"

#include <math.h>

struct end {
    long double major, minor; /* window coordinates, along and across the longer direction */
    double depth;
    const struct ref_vertex *source;
};

/* The row (column) in which the line crosses the centre of column (row) `i`. Coordinates on the
   grid make this a quotient of integers, computed exactly. */
static long double crossing_snapped(const struct end *from, const struct end *to, int i, int bits)
{
    int64_t from_major = (int64_t)ldexpl(from->major, bits);
    int64_t from_minor = (int64_t)ldexpl(from->minor, bits);
    int64_t length = (int64_t)ldexpl(to->major, bits) - from_major;
    int64_t rise = (int64_t)ldexpl(to->minor, bits) - from_minor;
    int64_t centre = ((int64_t)i << bits) + ((int64_t)1 << (bits - 1));
    int64_t numerator = from_minor * length + rise * (centre - from_major);
    int64_t denominator = length << bits;
    int64_t quotient = numerator / denominator;

    if (numerator % denominator < 0)
        quotient--;
    return (long double)quotient;
}

static long double crossing(const struct end *from, const struct end *to, int i, int bits)
{
    if (bits > 0)
        return crossing_snapped(from, to, i, bits);
    long double t = (i + 0.5L - from->major) / (to->major - from->major);
    return floorl(from->minor + t * (to->minor - from->minor));
}

/* Depth and attributes are linear on the screen, whatever the scene says about perspective. */
static void pixel(struct ref_target *target, const struct ref_triangle *triangle,
                  const struct end *from, const struct end *to, double t, int x, int y)
{
    double attribute[REF_ATTRIBUTES];
    double depth = from->depth + t * (to->depth - from->depth);

    if (!ref_target_cover(target, x, y, depth))
        return;
    for (int k = 0; k < REF_ATTRIBUTES; k++) {
        double a = from->source->attribute[k];
        attribute[k] = a + t * (to->source->attribute[k] - a);
    }
    ref_target_shade(target, x, y, depth, triangle, attribute, 0.0);
}

static void walk(struct ref_target *target, const struct ref_triangle *triangle,
                 const struct end *from, const struct end *to, bool steep)
{
    int columns = steep ? target->scene->height : target->scene->width;
    int rows = steep ? target->scene->width : target->scene->height;
    int first = ref_clamped_floor(ceill(from->major - 0.5L), columns);

    for (int i = first; i < columns && i + 0.5L < to->major; i++) {
        long double minor = crossing(from, to, i, target->subpixel_bits);
        if (!(minor >= 0 && minor < rows))
            continue;
        double t = (double)((i + 0.5L - from->major) / (to->major - from->major));
        int j = (int)minor;
        pixel(target, triangle, from, to, t, steep ? j : i, steep ? i : j);
    }
}

static void draw_line(struct ref_target *target, const struct ref_triangle *triangle,
                      const struct ref_vertex *v0, const struct ref_vertex *v1)
{
    struct ref_vertex vertex[2] = {*v0, *v1};
    struct end end[2];
    long double window[2][2];

    if (!ref_clip_line(vertex, &target->window, ref_guard_band(target->subpixel_bits)))
        return;
    for (int i = 0; i < 2; i++) {
        const struct ref_vertex *v = &vertex[i];
        window[i][0] = ref_window_x(v, &target->window) / v->w;
        window[i][1] = ref_window_y(v, &target->window) / v->w;
        for (int k = 0; k < 2 && target->subpixel_bits > 0; k++)
            window[i][k] = ldexpl((long double)ref_snap(window[i][k], target->subpixel_bits),
                                  -target->subpixel_bits);
    }
    bool steep = fabsl(window[1][1] - window[0][1]) > fabsl(window[1][0] - window[0][0]);
    for (int i = 0; i < 2; i++) {
        end[i].major = window[i][steep];
        end[i].minor = window[i][!steep];
        end[i].depth = ref_target_depth(target, vertex[i].z / vertex[i].w);
        end[i].source = &vertex[i];
    }
    if (end[0].major < end[1].major)
        walk(target, triangle, &end[0], &end[1], steep);
    else if (end[0].major > end[1].major)
        walk(target, triangle, &end[1], &end[0], steep);
}

void ref_raster_outline(struct ref_target *target, const struct ref_triangle *triangle)
{
    struct ref_triangle plain = *triangle;

    if (!ref_facing_is_drawn(target, ref_facing(triangle)))
        return;
    plain.textured = false;
    for (int i = 0; i < 3; i++)
        draw_line(target, &plain, &plain.vertex[i], &plain.vertex[(i + 1) % 3]);
}
