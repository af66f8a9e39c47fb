/* SPDX-License-Identifier: MIT */
#include "clip.h"

#include <math.h>

long double ref_guard_band(int subpixel_bits)
{
    return ldexpl(1.0L, 29 - (subpixel_bits > 0 ? subpixel_bits : 8));
}

/* How far inside plane `plane` a vertex is; >= 0 is inside. Near and far together leave w >= 0,
   and the guard band leaves of w = 0 only the point (0, 0, 0, 0), which is dropped at the end. */
static long double plane_distance(int plane, const struct ref_vertex *v,
                                  const struct ref_window *window, long double guard)
{
    switch (plane) {
    case 0:
        return v->w + v->z;
    case 1:
        return v->w - v->z;
    case 2:
        return guard * v->w + ref_window_x(v, window);
    case 3:
        return guard * v->w - ref_window_x(v, window);
    case 4:
        return guard * v->w + ref_window_y(v, window);
    default:
        return guard * v->w - ref_window_y(v, window);
    }
}

/* The point where an edge leaves a plane. It is always computed from the inside vertex towards
   the outside one, never in the order of the polygon: the two triangles that share an edge walk
   it in opposite directions and must cut it in the same point, to the last bit. */
static void cut(const struct ref_vertex *inside, long double d_inside,
                const struct ref_vertex *outside, long double d_outside, struct ref_vertex *out)
{
    long double t = d_inside / (d_inside - d_outside); /* d_inside >= 0 > d_outside: 0 <= t <= 1 */

    out->x = inside->x + t * (outside->x - inside->x);
    out->y = inside->y + t * (outside->y - inside->y);
    out->z = inside->z + t * (outside->z - inside->z);
    out->w = inside->w + t * (outside->w - inside->w);
    for (int k = 0; k < REF_ATTRIBUTES; k++) {
        double a = inside->attribute[k];
        out->attribute[k] = a + (double)t * (outside->attribute[k] - a);
    }
}

/* One plane of Sutherland and Hodgman (1974), in homogeneous coordinates. */
static void clip_polygon_by_plane(const struct ref_polygon *in, int plane,
                                  const struct ref_window *window, long double guard,
                                  struct ref_polygon *out)
{
    out->count = 0;
    for (int i = 0; i < in->count; i++) {
        const struct ref_vertex *from = &in->vertex[i];
        const struct ref_vertex *to = &in->vertex[(i + 1) % in->count];
        long double d_from = plane_distance(plane, from, window, guard);
        long double d_to = plane_distance(plane, to, window, guard);

        if (d_from >= 0)
            out->vertex[out->count++] = *from;
        if (d_from >= 0 && d_to < 0)
            cut(from, d_from, to, d_to, &out->vertex[out->count++]);
        else if (d_from < 0 && d_to >= 0)
            cut(to, d_to, from, d_from, &out->vertex[out->count++]);
    }
}

static void drop_vertices_at_infinity(struct ref_polygon *polygon)
{
    int kept = 0;

    for (int i = 0; i < polygon->count; i++)
        if (polygon->vertex[i].w > 0)
            polygon->vertex[kept++] = polygon->vertex[i];
    polygon->count = kept >= 3 ? kept : 0;
}

void ref_clip_triangle(const struct ref_vertex vertex[3], const struct ref_window *window,
                       long double guard, struct ref_polygon *polygon)
{
    struct ref_polygon other;

    polygon->count = 3;
    for (int i = 0; i < 3; i++)
        polygon->vertex[i] = vertex[i];
    for (int plane = 0; plane < REF_CLIP_PLANES; plane += 2) {
        clip_polygon_by_plane(polygon, plane, window, guard, &other);
        clip_polygon_by_plane(&other, plane + 1, window, guard, polygon);
    }
    drop_vertices_at_infinity(polygon);
}

bool ref_clip_line(struct ref_vertex end[2], const struct ref_window *window, long double guard)
{
    for (int plane = 0; plane < REF_CLIP_PLANES; plane++) {
        long double d0 = plane_distance(plane, &end[0], window, guard);
        long double d1 = plane_distance(plane, &end[1], window, guard);
        struct ref_vertex point;

        if (d0 < 0 && d1 < 0)
            return false;
        if (d1 < 0) {
            cut(&end[0], d0, &end[1], d1, &point);
            end[1] = point;
        } else if (d0 < 0) {
            cut(&end[1], d1, &end[0], d0, &point);
            end[0] = point;
        }
    }
    return end[0].w > 0 && end[1].w > 0;
}

struct ref_vertex ref_vertex_of(const struct ref_matrix *to_clip, const struct scene_vertex *in,
                                const int32_t color[3])
{
    double p[4];

    ref_from_q16(in->position, 4, p);
    ref_matrix_transform(to_clip, p, p);
    struct ref_vertex out = {p[0], p[1], p[2], p[3], {0}};
    for (int c = 0; c < 3; c++)
        out.attribute[c] = 255.0 * ref_unit_from_q16(color[c]);
    ref_from_q16(in->uv, 2, &out.attribute[REF_U]);
    return out;
}

bool ref_vertex_is_finite(const struct ref_vertex *v)
{
    return isfinite(v->x) && isfinite(v->y) && isfinite(v->z) && isfinite(v->w);
}

bool ref_clip_all_outside(const struct ref_vertex vertex[3])
{
    bool left = true, right = true, below = true, above = true;
    bool near = true, far = true, behind = true;

    for (int i = 0; i < 3; i++) {
        const struct ref_vertex *v = &vertex[i];
        left = left && v->x < -v->w;
        right = right && v->x > v->w;
        below = below && v->y < -v->w;
        above = above && v->y > v->w;
        near = near && v->z < -v->w;
        far = far && v->z > v->w;
        behind = behind && v->w <= 0;
    }
    return left || right || below || above || near || far || behind;
}
