/* SPDX-License-Identifier: MIT */
/*
 * Transforms of cameras, projections, and billboards, which turn to a camera.
 */
#include "qtri/error.h"
#include "qtri/transform.h"

#include <stdbool.h>
#include <stddef.h>

#include "../bits/bits.h"
#include "../math/q16_trig.h"
#include "plain.h"
#include "row.h"

/* ---- Cameras and projections ---- */

/* side = forward x up, normalised; false: up is 0 or parallel to forward. */
static bool set_side(qtri_wide side[3], const qtri_wide forward[3], const qtri_vec3 *up)
{
    qtri_wide unit[3];
    qtri_wide_from_vec3(unit, up);
    if (!qtri_wide_normalize(unit)) {
        return false;
    }
    qtri_wide_cross(side, forward, unit);
    for (int axis = 0; axis < 3; axis++) {
        if (side[axis].e > 112) { /* below 2^-50: the noise of parallel unit vectors */
            qtri_wide_set(&side[axis], 0, 0);
        }
    }
    return qtri_wide_normalize(side);
}

/* forward x up, normalised; y, or else z, stands in for an up that is 0 or parallel to forward. */
static void side_axis(qtri_wide side[3], const qtri_wide forward[3], const qtri_vec3 *up)
{
    static const qtri_vec3 y = {0, Q16_ONE, 0};
    static const qtri_vec3 z = {0, 0, Q16_ONE};
    if (!set_side(side, forward, up) && !set_side(side, forward, &y)) {
        (void)set_side(side, forward, &z);
    }
}

void qtri_transform_look_at(qtri_transform *t, qtri_vec3 eye, qtri_vec3 center, qtri_vec3 up)
{
    QTRI_ASSERT(t != NULL);
    QTRI_ASSERT(qtri_is_sight(eye, center));
    qtri_wide position[3];
    qtri_wide axis[3][3]; /* side, up, forward */
    qtri_wide_from_vec3(position, &eye);
    qtri_wide_set(&axis[2][0], (int64_t)center.x - eye.x, 16);
    qtri_wide_set(&axis[2][1], (int64_t)center.y - eye.y, 16);
    qtri_wide_set(&axis[2][2], (int64_t)center.z - eye.z, 16);
    if (!qtri_wide_normalize(axis[2])) {
        qtri_wide_set(&axis[2][2], -1, 0);
    }
    side_axis(axis[0], axis[2], &up);
    qtri_wide_cross(axis[1], axis[0], axis[2]);

    qtri_transform builder;
    qtri_transform_identity(&builder);
    for (int i = 0; i < 3; i++) {
        axis[2][i].m = -axis[2][i].m; /* the eye looks down -z */
    }
    for (int i = 0; i < 3; i++) {
        qtri_row_about(&builder.row[i], axis[i], position, NULL);
    }
    qtri_transform_mul(t, t, &builder);
}

#define DEGREES(n) ((uint32_t)(n)*65536u)

/* *out = above / below */
static void quotient(qtri_wide *out, int64_t above, int64_t below)
{
    const qtri_wide divisor = qtri_wide_make(below, 0);
    qtri_wide_set(out, above, 0);
    qtri_wide_div_by(out, &divisor);
}

/* cot(degrees / 2), or its inverse, for degrees < 16: cos h / (h (sin h / h)), which cancels
   nowhere: within 2^-29 of itself. */
static void narrow_cotangent(qtri_wide *out, uint32_t degrees, bool is_inverse)
{
    const uint64_t half_q54 = (uint64_t)degrees * QTRI_RADIANS_PER_DEGREE_Q37; /* < 2^52 */
    const uint32_t half_q31 = (uint32_t)((half_q54 + 0x400000u) >> 23);        /* < 2^29 */
    const uint32_t square_q31 = qtri_mul_q31(half_q31, half_q31);
    const qtri_wide ratio = qtri_wide_make(qtri_sine_ratio_q31(square_q31), 31);
    const qtri_wide cosine = qtri_wide_make(qtri_cosine_q31(square_q31), 31);
    qtri_wide sine = qtri_wide_make((int64_t)half_q54, 54);
    qtri_wide_mul_by(&sine, &ratio);
    *out = is_inverse ? sine : cosine;
    qtri_wide_div_by(out, is_inverse ? &cosine : &sine);
}

/*
 * cot(degrees / 2), from the form of the half-angle formula that does not cancel. Near 0 and 180
 * the sine that it has left keeps few digits of its 30: the angle, or what it lacks to 180, has
 * all.
 */
static void half_cotangent(qtri_wide *out, q16 degrees)
{
    const uint32_t size = qtri_magnitude32(degrees);
    const uint32_t rest = size < DEGREES(90) ? size : DEGREES(180) - size; /* beyond 180: large */
    if (rest < DEGREES(16)) {
        narrow_cotangent(out, rest, size != rest);
        if (degrees < 0) {
            out->m = -out->m;
        }
        return;
    }
    int32_t sine_q30;
    int32_t cosine_q30;
    qtri_sincos_deg_q30(degrees, &sine_q30, &cosine_q30);
    int64_t one_q30 = (int64_t)1 << 30;
    int64_t above = cosine_q30 >= 0 ? one_q30 + cosine_q30 : sine_q30;
    int64_t below = cosine_q30 >= 0 ? sine_q30 : one_q30 - cosine_q30;
    quotient(out, above, below);
}

/* The row of z: 0 0 (f + n) / (n - f), or the negative of that, and 2 f n / (n - f) */
static void depth_row(qtri_row *row, q16 near_z, q16 far_z, bool negative)
{
    const qtri_wide divisor = qtri_wide_make((int64_t)near_z - far_z, 16);
    const qtri_wide wide_near = qtri_wide_make(near_z, 16);
    qtri_wide slope = qtri_wide_make((int64_t)far_z + near_z, 16);
    qtri_wide offset = qtri_wide_make(far_z, 15);
    qtri_wide_div_by(&slope, &divisor);
    if (negative) {
        slope.m = -slope.m;
    }
    qtri_wide_mul_by(&offset, &wide_near);
    qtri_wide_div_by(&offset, &divisor);
    qtri_row_from_two(row, 2, &slope, 3, &offset);
}

/* The row of w: w = toward z */
static void set_w_row(qtri_row *row, int64_t toward)
{
    const qtri_wide one = qtri_wide_make(toward, 0);
    qtri_row_from_two(row, 2, &one, 2, &one);
}

static void perspective(qtri_transform *t, q16 fovy, q16 aspect, q16 near_z, q16 far_z,
                        int64_t toward)
{
    QTRI_ASSERT(t != NULL);
    /* A plain number in place of a Q16.16 is below 1/100 degree, or a ratio of 1 : 10000. */
    QTRI_ASSERT(qtri_magnitude32(fovy) > 360);
    QTRI_ASSERT(qtri_magnitude32(fovy) < (uint32_t)180 << 16);
    QTRI_ASSERT(qtri_magnitude32(aspect) > 6);
    QTRI_ASSERT(near_z != 0 && far_z != 0 && near_z != far_z);
    QTRI_ASSERT(qtri_is_length(near_z) && qtri_is_length(far_z));
    qtri_transform builder;
    qtri_wide g;
    const qtri_wide divisor = qtri_wide_make(aspect, 16);
    half_cotangent(&g, fovy);
    qtri_row_from_two(&builder.row[1], 1, &g, 1, &g);
    qtri_wide_div_by(&g, &divisor);
    qtri_row_from_two(&builder.row[0], 0, &g, 0, &g);
    depth_row(&builder.row[2], near_z, far_z, toward == 1);
    set_w_row(&builder.row[3], toward);
    qtri_transform_mul(t, t, &builder);
}

void qtri_transform_perspective(qtri_transform *t, q16 fovy, q16 aspect, q16 near_z, q16 far_z)
{
    perspective(t, fovy, aspect, near_z, far_z, -1);
}

/* z' = z f/(f-n) - fn/(f-n) in 0..w becomes 2 z' - w: the OpenGL row for a camera along +z. */
void qtri_transform_perspective_d3d(qtri_transform *t, q16 fovy, q16 aspect, q16 near_z, q16 far_z)
{
    perspective(t, fovy, aspect, near_z, far_z, 1);
}

/* 2 n / (high - low) in column i, and (high + low) / (high - low) for z */
static void frustum_row(qtri_row *row, int i, q16 low, q16 high, q16 near_z)
{
    qtri_wide slope;
    qtri_wide shear;
    quotient(&slope, (int64_t)near_z * 2, (int64_t)high - low);
    quotient(&shear, (int64_t)high + low, (int64_t)high - low);
    qtri_row_from_two(row, i, &slope, 2, &shear);
}

void qtri_transform_frustum(qtri_transform *t, q16 left, q16 right, q16 bottom, q16 top, q16 near_z,
                            q16 far_z)
{
    QTRI_ASSERT(t != NULL);
    QTRI_ASSERT(left != right && bottom != top);
    QTRI_ASSERT(near_z != 0 && far_z != 0 && near_z != far_z);
    QTRI_ASSERT(qtri_is_apart(left, right) && qtri_is_apart(bottom, top));
    QTRI_ASSERT(qtri_is_length(near_z) && qtri_is_length(far_z));
    qtri_transform builder;
    frustum_row(&builder.row[0], 0, left, right, near_z);
    frustum_row(&builder.row[1], 1, bottom, top, near_z);
    depth_row(&builder.row[2], near_z, far_z, false);
    set_w_row(&builder.row[3], -1);
    qtri_transform_mul(t, t, &builder);
}

/* 2 / `length` in column i, and sum / divisor */
static void ortho_row(qtri_row *row, int i, int64_t length, int64_t sum, int64_t divisor)
{
    qtri_wide slope;
    qtri_wide offset;
    quotient(&slope, (int64_t)2 * 65536, length);
    quotient(&offset, sum, divisor);
    qtri_row_from_two(row, i, &slope, 3, &offset);
}

void qtri_transform_ortho(qtri_transform *t, q16 left, q16 right, q16 bottom, q16 top, q16 near_z,
                          q16 far_z)
{
    QTRI_ASSERT(t != NULL);
    QTRI_ASSERT(left != right && bottom != top && near_z != far_z);
    QTRI_ASSERT(qtri_is_apart(left, right) && qtri_is_apart(bottom, top));
    QTRI_ASSERT(qtri_is_apart(near_z, far_z));
    const int64_t width = (int64_t)right - left;
    const int64_t height = (int64_t)top - bottom;
    const int64_t depth = (int64_t)near_z - far_z;
    qtri_transform builder;
    qtri_transform_identity(&builder);
    ortho_row(&builder.row[0], 0, width, (int64_t)right + left, -width);
    ortho_row(&builder.row[1], 1, height, (int64_t)top + bottom, -height);
    ortho_row(&builder.row[2], 2, depth, (int64_t)far_z + near_z, depth);
    qtri_transform_mul(t, t, &builder);
}

void qtri_transform_orbit(qtri_transform *t, qtri_vec3 center, q16 distance, q16 azimuth,
                          q16 elevation)
{
    QTRI_ASSERT(t != NULL);
    QTRI_ASSERT(qtri_is_length(distance));
    const qtri_vec3 back = {0, 0, q16_neg(distance)};
    const qtri_vec3 to_origin = {q16_neg(center.x), q16_neg(center.y), q16_neg(center.z)};
    qtri_transform_translate(t, back);
    qtri_transform_rotate_x(t, elevation);
    qtri_transform_rotate_y(t, q16_neg(azimuth));
    qtri_transform_translate(t, to_origin);
}

/* ---- Direct3D's forms ---- */

/*
 * What looks down -z looks along +z when it is turned half about y: from the rows right, up and
 * backward of OpenGL's camera come left, up and forward, where left is right of a left-handed
 * world.
 */
void qtri_transform_look_at_d3d(qtri_transform *t, qtri_vec3 eye, qtri_vec3 center, qtri_vec3 up)
{
    const qtri_vec3 turn = {-Q16_ONE, Q16_ONE, -Q16_ONE};
    qtri_transform_scale(t, turn);
    qtri_transform_look_at(t, eye, center, up);
}

/* From eye space along +z to eye space along -z. */
static void mirror(qtri_transform *t)
{
    const qtri_vec3 factor = {Q16_ONE, Q16_ONE, -Q16_ONE};
    qtri_transform_scale(t, factor);
}

void qtri_transform_frustum_d3d(qtri_transform *t, q16 left, q16 right, q16 bottom, q16 top,
                                q16 near_z, q16 far_z)
{
    qtri_transform_frustum(t, left, right, bottom, top, near_z, far_z);
    mirror(t);
}

void qtri_transform_ortho_d3d(qtri_transform *t, q16 left, q16 right, q16 bottom, q16 top,
                              q16 near_z, q16 far_z)
{
    qtri_transform_ortho(t, left, right, bottom, top, near_z, far_z);
    mirror(t);
}

/* ---- Billboards ---- */

/* An axis of the camera in the world: a row's linear part, of length 1. False: that is 0. */
static bool axis_of(qtri_wide axis[3], const qtri_row *row)
{
    qtri_row_axis(axis, row);
    return qtri_wide_normalize(axis);
}

/* t = t builder, a transform whose columns are axis[0..2]. */
static void turn(qtri_transform *t, qtri_wide axis[3][3])
{
    qtri_transform builder;
    qtri_transform_identity(&builder);
    for (int i = 0; i < 3; i++) {
        const qtri_wide none = qtri_wide_make(0, 0);
        const qtri_wide element[4] = {axis[0][i], axis[1][i], axis[2][i], none};
        qtri_row_from_wide(&builder.row[i], element);
    }
    qtri_transform_mul(t, t, &builder);
}

void qtri_transform_billboard(qtri_transform *t, const qtri_transform *camera)
{
    QTRI_ASSERT(t != NULL);
    QTRI_ASSERT(camera != NULL);
    qtri_wide axis[3][3];
    if (axis_of(axis[0], &camera->row[0]) && axis_of(axis[1], &camera->row[1]) &&
        axis_of(axis[2], &camera->row[2])) {
        turn(t, axis);
    }
}

/* y stays; z is the horizontal part of the camera's z, x = y cross z. */
void qtri_transform_billboard_upright(qtri_transform *t, const qtri_transform *camera)
{
    QTRI_ASSERT(t != NULL);
    QTRI_ASSERT(camera != NULL);
    qtri_wide axis[3][3];
    if (!axis_of(axis[2], &camera->row[2])) {
        return;
    }
    axis[2][1] = qtri_wide_make(0, 0);
    if (!qtri_wide_normalize(axis[2])) {
        return; /* it looks straight down or up: there is no side to turn */
    }
    for (int i = 0; i < 3; i++) {
        axis[1][i] = qtri_wide_make(i == 1, 0);
    }
    qtri_wide_cross(axis[0], axis[1], axis[2]);
    turn(t, axis);
}
