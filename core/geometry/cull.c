/* SPDX-License-Identifier: MIT */
/*
 * Bounding boxes and balls of meshes, their frustum culling, and back-face culling by planes.
 */
#include "qtri/error.h"
#include "qtri/mesh.h"

#include <stddef.h>

#include "../bits/bits.h"
#include "../math/unit.h"
#include "cull.h"

/* Position i, rounded down and up to Q16.16. */
static void get_position(q16 low[3], q16 high[3], const qtri_mesh *mesh, uint32_t i)
{
    if (mesh->positions16 == NULL) {
        const qtri_vec3 *p = &mesh->positions[i];
        low[0] = high[0] = p->x;
        low[1] = high[1] = p->y;
        low[2] = high[2] = p->z;
        return;
    }
    const qtri_position16 *p = &mesh->positions16[i];
    const int16_t n[3] = {p->x, p->y, p->z};
    const q16 origin[3] = {mesh->origin.x, mesh->origin.y, mesh->origin.z};
    for (int axis = 0; axis < 3; axis++) {
        const int64_t way_q31 = qtri_mul_s32(mesh->extent, n[axis]);
        low[axis] = qtri_saturate32(origin[axis] + (way_q31 >> 15));
        high[axis] = qtri_saturate32(origin[axis] + ((way_q31 + 32767) >> 15));
    }
}

static uint32_t count_of(const qtri_mesh *mesh)
{
    return mesh->positions16 != NULL || mesh->positions != NULL ? mesh->vertex_count : 0;
}

/*
 * The middle of low..high, rounded down, and half its length, rounded up: where one is rounded the
 * other is, too, so that they reach `high` exactly and `low` at least. Only from the lowest to the
 * highest number the half does not fit, and is clamped to one less.
 */
static void set_axis(q16 *center, q16 *half, q16 low, q16 high)
{
    const int64_t sum = (int64_t)low + high;
    *center = (q16)(sum >> 1);
    *half = qtri_saturate32((((int64_t)high - low) + 1) >> 1);
}

qtri_box qtri_mesh_box(const qtri_mesh *mesh)
{
    QTRI_ASSERT(mesh != NULL);
    static const qtri_box empty = {{0, 0, 0}, {0, 0, 0}};
    const uint32_t count = count_of(mesh);
    if (count == 0) {
        return empty;
    }
    q16 low[3];
    q16 high[3];
    get_position(low, high, mesh, 0);
    for (uint32_t i = 1; i < count; i++) {
        q16 down[3];
        q16 up[3];
        get_position(down, up, mesh, i);
        for (int axis = 0; axis < 3; axis++) {
            low[axis] = qtri_least32(low[axis], down[axis]);
            high[axis] = qtri_greatest32(high[axis], up[axis]);
        }
    }
    qtri_box box;
    set_axis(&box.center.x, &box.half.x, low[0], high[0]);
    set_axis(&box.center.y, &box.half.y, low[1], high[1]);
    set_axis(&box.center.z, &box.half.z, low[2], high[2]);
    return box;
}

/* |a - b|, below 2^32. */
static uint32_t difference(q16 a, q16 b)
{
    return (uint32_t)qtri_magnitude64((int64_t)a - b);
}

qtri_ball qtri_mesh_ball(const qtri_mesh *mesh)
{
    const qtri_box box = qtri_mesh_box(mesh);
    const uint32_t count = count_of(mesh);
    uint64_t most = 0;
    const q16 center[3] = {box.center.x, box.center.y, box.center.z};
    for (uint32_t i = 0; i < count; i++) {
        q16 down[3];
        q16 up[3];
        uint64_t square = 0; /* of half the distance to the farther of both roundings */
        get_position(down, up, mesh, i);
        for (int axis = 0; axis < 3; axis++) { /* halves rounded up, <= 2^31: three fit 64 bits */
            const uint32_t d = difference(down[axis], center[axis]);
            const uint32_t e = difference(up[axis], center[axis]);
            const uint32_t half = ((d > e ? d : e) >> 1) + 1;
            square += qtri_mul_u32(half, half);
        }
        most = square > most ? square : most;
    }
    qtri_ball ball = {box.center, 0};
    if (count > 0) {
        ball.radius = qtri_saturate32((int64_t)(2 * (qtri_sqrt64_round(most) + 1)));
    }
    return ball;
}

/* The sides of a rectangle, the near and the far plane: lower, then upper, of x, y and z. */
enum { SIDES = 6 };

/* Distance inside a side at e: e w - x, or e w + x on lower sides. |v| < 2^43, |e| <= 2^15. */
static int64_t within(const int64_t v[4], int side, int32_t edge)
{
    const int64_t x = v[side / 2];
    return edge * v[3] + (side % 2 == 0 ? x : -x);
}

/*
 * A half space of homogeneous coordinates that holds the corners holds the box; what is seen of it
 * has w > 0, and x / w beyond the edge. Edges are moved out by a pixel, for lines on them. The
 * corner that is most within a side is its center plus what every axis adds at most, each in units
 * of 2^18; the bits cut off move the four sums by less than |e| + 2 units each.
 */
bool qtri_projector_misses(const qtri_projector *projector, const qtri_box *box,
                           const int32_t low[2], const int32_t high[2])
{
    enum { UNIT_LOG2 = 18 };
    const int32_t edge[SIDES] = {1 - low[0], high[0] + 1, 1 - low[1], high[1] + 1, 1, 1};
    const int32_t half[3] = {box->half.x, box->half.y, box->half.z};
    qtri_clip_vertex v;
    qtri_projector_point(projector, &box->center, &v);
    const int64_t center[4] = {v.x >> UNIT_LOG2, v.y >> UNIT_LOG2, v.z >> UNIT_LOG2,
                               v.w >> UNIT_LOG2};
    for (int side = 0; side < SIDES; side++) {
        int64_t most = within(center, side, edge[side]);
        if (most >= 0) {
            continue;
        }
        most += 4 * ((int64_t)qtri_magnitude32(edge[side]) + 2);
        for (int axis = 0; axis < 3; axis++) {
            int64_t reach[4];
            for (int i = 0; i < 4; i++) {
                reach[i] = qtri_mul_s32(projector->row.wide[i].m[axis], half[axis]) >>
                           projector->shift[i] >> UNIT_LOG2;
            }
            most += (int64_t)qtri_magnitude64(within(reach, side, edge[side]));
        }
        if (most < 0) {
            return true;
        }
    }
    return false;
}

bool qtri_view_sees_box(const qtri_view *view, const qtri_transform *pose, const qtri_box *box)
{
    QTRI_ASSERT(view != NULL);
    QTRI_ASSERT(pose != NULL);
    QTRI_ASSERT(box != NULL);
    QTRI_ASSERT(box->half.x >= 0 && box->half.y >= 0 && box->half.z >= 0);
    qtri_projector projector;
    const qtri_viewport *viewport = &view->viewport;
    qtri_projector_init_view(&projector, view, pose, 0, NULL);
    const int32_t limit = QTRI_VIEWPORT_MAX;
    const int32_t low[2] = {qtri_hold32(viewport->x, -limit, limit),
                            qtri_hold32(viewport->y, -limit, limit)};
    const int32_t high[2] = {low[0] + qtri_hold32(viewport->width, 0, limit),
                             low[1] + qtri_hold32(viewport->height, 0, limit)};
    return !qtri_projector_misses(&projector, box, low, high);
}

/* By the box around it, in object space: that of a turned ball is as good as any. */
bool qtri_view_sees_ball(const qtri_view *view, const qtri_transform *pose, const qtri_ball *ball)
{
    QTRI_ASSERT(ball != NULL);
    QTRI_ASSERT(ball->radius >= 0);
    const qtri_box box = {ball->center, {ball->radius, ball->radius, ball->radius}};
    return qtri_view_sees_box(view, pose, &box);
}

/* ---- Faces ---- */

/*
 * The bound on faces.
 *
 * Units. Points are p = (position - origin) / extent, |p_i| <= 1, |p| <= R for R = radius_q14 /
 * 2^14 >= 1. A row's value at p is m . p + t with m and t as they stand, which counts halves of a
 * unit of qtri_row16_sum and stays below 2^30 (+ 2^4). The pixel x is f X / W, f = 2^(shift[0] -
 * shift[3]).
 *
 * Area. Let c be the m of W's row and w0 its t; a that of X's row less x0 c, where x0 = t / w0 is
 * X / W of the origin, b that of Y's row likewise. About the origin's place on the screen a point
 * then has X = a . p and Y = b . p. Corners p0 p1 p2 with the normal n of length 1, the area A and
 * D = n . p0 span on the screen twice the area
 *
 *   S = f^2 det(X, Y, W of each) / (W0 W1 W2) = f^2 w0 2A (n . k - w D) / (W0 W1 W2)
 *
 * with k = a x b and w = -c . k / w0: (k, w) is where all three rows are 0, the eye. y points down:
 * S > 0 turns away. Mirrored, uneven and parallel views are no special cases.
 *
 * Snapping. What is drawn has corners up to h pixels off in x and in y. That changes S by at most h
 * times the sum of |dx| + |dy| over the edges, plus 4 h^2, twice the area of the largest triangle
 * in a square of side 2h. Let G be the larger of |a + b| and |a - b|, the most of |a . u| + |b . u|
 * for |u| = 1, and g = |c| R / w0. For an edge of length l from p0 to p1
 *
 *   dx / f = X1 / W1 - X0 / W0 = (a . (p1 - p0) - X0 / W0 c . (p1 - p0)) / W1,
 *
 * and |X0 / W0| + |Y0 / W0| <= G R / (w0 (1 - g)), so |dx| + |dy| <= f l G (1 + g / (1 - g)) / W1,
 * or over W0, if p0 and p1 change places. As W <= w0 (1 + g), a face of perimeter L is drawn turned
 * away where
 *
 *   S W0 W1 W2 > h f L G w0^2 (1 + g)^2 / (1 - g) + 4 h^2 w0^3 (1 + g)^3.
 *
 * Let s be the length of x y z along n, at least 16; r the inner circle's radius, 2A = r L, s / r
 * <= thin; and L >= 6 sqrt(3) r in every triangle, so that s / 2A <= thin^2 / (6 sqrt(3) s).
 * Divided by f^2 w0 2A / s, with H = h w0 / f,
 *
 *   s (n . k - w D) > H G thin (1 + g)^2 / (1 - g) + H^2 thin^2 / 4,
 *
 * where the 1/4 is more than 4 (1 + g)^3 / (6 sqrt(3) 16) < 1/5.
 *
 * Rounding. x y z is s n + e, e at right angles to n and |e| <= error: that adds e . (k - w p0), at
 * most error (|k| + |w| R). d is off by 1/2 and adds |w| / 2.
 *
 * h is half of 1/256 pixel, and what separates the rows of the vertex stage from a, b and c: a wide
 * row is 12 away from the compact one, whose three m and t lost up to 4; a sum is cut off by 2, t
 * here by 1; a and b are off by 3 an element, see subtract_w_row(). ROW_ERROR is more than that. An
 * error of W counts |X| / W <= 2^30 / W times: altogether ROW_ERROR (1 + 2^30 / W) f / W pixels.
 */
enum { ROW_ERROR = 32, NEAREST = 16, SNAPPED_MAX_LOG2 = 24, BEHIND_MAX_LOG2 = 29 };

/* |v|, not less, for |v_i| < 2^30.5. */
static uint32_t length_above(const int32_t v[3])
{
    uint64_t square = 0;
    for (int i = 0; i < 3; i++) {
        square += (uint64_t)qtri_mul_s32(v[i], v[i]);
    }
    uint64_t rest;
    return qtri_sqrt64_floor(square, &rest) + 1;
}

/* G, not less. */
static uint32_t reach_above(const int32_t a[3], const int32_t b[3])
{
    uint64_t square = 0;
    int64_t between = 0;
    for (int i = 0; i < 3; i++) {
        square += (uint64_t)qtri_mul_s32(a[i], a[i]) + (uint64_t)qtri_mul_s32(b[i], b[i]);
        between += qtri_mul_s32(a[i], b[i]);
    }
    uint64_t rest;
    return qtri_sqrt64_floor(square + 2 * qtri_magnitude64(between), &rest) + 1; /* < 2^63.7 */
}

/* x 2^shift, rounded down; x < 2^31, |shift| <= 30. */
static uint64_t times_power(uint32_t x, int32_t shift)
{
    return shift >= 0 ? (uint64_t)x << shift : x >> -shift;
}

/* The range of W over the mesh, and what depends on it. */
typedef struct distance {
    int32_t t;            /* w0, W at the origin */
    int32_t slope_q30[3]; /* c / w0 */
    uint32_t reach;       /* |c| R, the most that W differs from w0 */
    uint32_t least;       /* W at the nearest point, not more */
    uint32_t inverse_q10; /* 1 / (1 - g), not less */
    uint32_t spread_q10;  /* (1 + g)^2 / (1 - g), not less */
} distance;

/* False: W is not above w0 / 16 everywhere in the mesh. */
static bool find_distance(distance *w, const qtri_projector *projector, uint32_t radius_q14)
{
    const qtri_row16 *row = &projector->row.compact[3];
    int32_t c[3];
    for (int i = 0; i < 3; i++) {
        c[i] = qtri_row16_coefficient(row, i);
    }
    w->t = qtri_row16_translation(row);
    const uint64_t reach = (qtri_mul_u32(length_above(c), radius_q14) >> 14) + 1;
    const int64_t least = w->t - (int64_t)reach - ROW_ERROR;
    if (w->t <= 0 || least <= 0 || least <= w->t / NEAREST) { /* so |c| < w0, g < 15/16 */
        return false;
    }
    w->reach = (uint32_t)reach;
    w->least = (uint32_t)least;
    const int32_t zeros = qtri_clz32((uint32_t)w->t);
    const int32_t inverse = qtri_reciprocal_below((uint32_t)w->t << zeros); /* 2^62 / that */
    for (int i = 0; i < 3; i++) { /* within 2: the inverse is off by 1, half of that counts */
        int32_t c_q31 = c[i] * ((int32_t)1 << (zeros - 1));
        w->slope_q30[i] = (int32_t)(qtri_mul_s32(c_q31, inverse) >> 31);
    }
    /* Off by 2^-16 and cut off: 2 more are not less. */
    const int32_t least_zeros = qtri_clz32(w->least);
    const int32_t least_inverse = qtri_reciprocal_below(w->least << least_zeros);
    w->inverse_q10 = (uint32_t)(qtri_mul_s32(w->t, least_inverse) >> (52 - least_zeros)) + 2;
    const uint32_t most = (uint32_t)w->t + w->reach + ROW_ERROR; /* < 2^31 */
    const uint32_t most_q14 = (uint32_t)(qtri_mul_u32(most, (uint32_t)inverse) >> (48 - zeros)) + 2;
    w->spread_q10 = ((((most_q14 * most_q14) >> 14) + 1) * w->inverse_q10 >> 14) + 1; /* < 2^17 */
    return true;
}

/* All between the near and the far plane: |z - w| <= |rz - rw| R, and near it is 2 w. */
static bool is_between(const qtri_projector *projector, const distance *w, uint32_t radius_q14)
{
    const qtri_row16 *row = projector->row.compact;
    uint64_t sum = 0;
    for (int i = 0; i < 3; i++) {
        sum += qtri_magnitude32(qtri_row16_coefficient(&row[3], i) -
                                qtri_row16_coefficient(&row[2], i));
    }
    const int64_t slack = (int64_t)((sum * radius_q14) >> 14) + 2 * ROW_ERROR; /* < 2^35 */
    const int64_t z = qtri_row16_translation(&row[2]);
    return w->t - z >= slack && w->t + z >= slack + 2 * (int64_t)w->reach;
}

/*
 * The derivation's a or b: the m of X's or Y's row less x0 c = t slope. |t slope| <= |t|, so it
 * stays below 2^30 (+ 2^5). Off by 3: 2 from the slope, 1 cut off.
 */
static void subtract_w_row(int32_t out[3], const qtri_row16 *row, const int32_t slope_q30[3])
{
    const int32_t t = qtri_row16_translation(row);
    for (int i = 0; i < 3; i++) {
        out[i] = qtri_row16_coefficient(row, i) - (int32_t)(qtri_mul_s32(t, slope_q30[i]) >> 30);
    }
}

/* H: how far snapping moves a corner, in the scale of rows. */
static uint64_t snapped(const distance *w, int32_t up)
{
    const uint64_t beside = (uint64_t)1 << (qtri_clz32(w->least) - 1); /* >= 2^30 / W */
    const uint64_t rows = (ROW_ERROR * (beside + 1) * w->inverse_q10) >> 10;
    return (times_power((uint32_t)w->t, up) >> 9) + rows + 2;
}

/* A face whose qtri_eye_side() is at least this turns away, snapped or not: see the bound on faces.
   k lost `down` bits; UINT64_MAX: no face is sure to turn away. */
static uint64_t back_face_bound(const qtri_eye *eye, const qtri_faces *faces, uint32_t radius_q14,
                                const distance *w, uint64_t moved, uint32_t reach, int32_t down)
{
    const uint64_t blur = ((moved * reach) >> down) + 1; /* < 2^(24 + 32) */
    const uint64_t both = moved * faces->thin;
    if (blur >> 31 != 0 || both >> 31 != 0) {
        return UINT64_MAX;
    }
    const uint64_t spread = ((blur * w->spread_q10) >> 10) + 1;
    if (spread >> 32 != 0) {
        return UINT64_MAX;
    }
    uint64_t bound = (spread * faces->thin) >> 9; /* k counts 2^-9 */
    bound += ((both * both) >> 11) >> down;
    /* x y z and d. */
    const int32_t xyz[3] = {eye->x, eye->y, eye->z};
    const uint32_t size = qtri_magnitude32(eye->w);
    const uint64_t way = length_above(xyz) + 2 + ((qtri_mul_u32(size, radius_q14)) >> 14) + 2;
    bound += (way * faces->error_q16) >> 16;
    /* An element of the eye is off by less than 1.1: four times 128 of that, and all cut off. */
    return bound + size / 2 + 1024;
}

bool qtri_eye_find(qtri_eye *eye, const qtri_projector *projector, const qtri_faces *faces)
{
    const uint32_t radius_q14 = faces->radius_q14 < 1u << 14 ? 1u << 14 : faces->radius_q14;
    const int32_t up = projector->shift[3] - projector->shift[0]; /* f = 2^-up */
    distance w;
    if (!find_distance(&w, projector, radius_q14) || !is_between(projector, &w, radius_q14)) {
        return false;
    }
    /* |x| <= 2^30 f / W: below 2^13. */
    const uint64_t moved = snapped(&w, up);
    if (times_power(w.least, up) >> 17 == 0 || moved >> SNAPPED_MAX_LOG2 != 0) {
        return false;
    }
    int32_t a[3], b[3], k[3];
    int64_t cross[3];
    int64_t along = 0;
    subtract_w_row(a, &projector->row.compact[0], w.slope_q30);
    subtract_w_row(b, &projector->row.compact[1], w.slope_q30);
    qtri_cross64(cross, a, b); /* < 2^61.1 */
    const int32_t down = qtri_align32(k, cross, 30);
    if (down < 0) {
        return false; /* seen from the side */
    }
    for (int i = 0; i < 3; i++) {
        along += qtri_mul_s32(w.slope_q30[i], k[i]); /* |c| |k| <= 2^30 2^30.8 */
    }
    eye->x = k[0] >> 9;
    eye->y = k[1] >> 9;
    eye->z = k[2] >> 9;
    eye->w = (int32_t)(along >> 39);
    const uint64_t bound =
        back_face_bound(eye, faces, radius_q14, &w, moved, reach_above(a, b), down);
    eye->behind = (int32_t)(bound & INT32_MAX);
    return bound >> BEHIND_MAX_LOG2 == 0;
}

void qtri_eye_mirror(qtri_eye *eye)
{
    eye->x = -eye->x;
    eye->y = -eye->y;
    eye->z = -eye->z;
    eye->w = -eye->w;
}
