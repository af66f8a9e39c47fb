/* SPDX-License-Identifier: MIT */
/*
 * Quaternions for orientations: w + xi + yj + zk, Hamilton's product, Q16.16 components.
 *
 * Every function is defined for every argument. Where it takes an orientation, the quaternion need
 * not have unit length: its direction counts, at 30 fraction bits; zero stands for the identity.
 * q and -q are the same orientation. Angles are degrees, counter-clockwise seen against the axis.
 * Results are within .52 ULP of a component where not said otherwise, unit lengths within 1.01 ULP.
 * Sources: Shoemake, "Animating rotation with quaternion curves", SIGGRAPH 1985; Shepperd,
 * "Quaternion from rotation matrix", J. Guidance and Control 1, 1978.
 */
#ifndef QTRI_QUAT_H
#define QTRI_QUAT_H

#include "mat.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A quaternion w + x i + y j + z k; a rotation where its length is 1. */
typedef struct qtri_quat {
    q16 w, x, y, z;
} qtri_quat;

/* 1, which turns nothing. */
qtri_quat qtri_quat_identity(void);

/* A turn about an axis of any length, counter-clockwise seen against it. Axis 0: identity. */
qtri_quat qtri_quat_from_axis_deg(qtri_vec3 axis, q16 degrees);

/* The orders of mat.h: xyz turns about x first, then y, then z, about the fixed axes. */
qtri_quat qtri_quat_from_euler_deg(qtri_vec3 degrees, qtri_euler order);

/*
 * Of a rotation matrix, by Shepperd's method; w >= 0. The half ULPs of the matrix's own elements
 * come out as up to 1.5 ULP. A matrix that is no rotation gives a unit quaternion near it.
 */
qtri_quat qtri_quat_from_mat3(const qtri_mat3 *m);
qtri_quat qtri_quat_from_mat4(const qtri_mat4 *m); /* of its linear part */

/* The rotation of a unit quaternion as a matrix. */
qtri_mat3 qtri_quat_to_mat3(qtri_quat a);
qtri_mat4 qtri_quat_to_mat4(qtri_quat a);

/* First b, then a: rotate(mul(a, b), v) = rotate(a, rotate(b, v)). Correctly rounded. */
qtri_quat qtri_quat_mul(qtri_quat a, qtri_quat b);

q16 qtri_quat_dot(qtri_quat a, qtri_quat b); /* correctly rounded */
qtri_quat qtri_quat_conjugate(qtri_quat a);  /* w, -x, -y, -z */

/* conjugate / |a|^2, within .501 ULP, saturated; zero gives the identity. */
qtri_quat qtri_quat_inverse(qtri_quat a);

/* a / |a|, each component within .501 ULP; zero gives the identity. */
qtri_quat qtri_quat_normalize(qtri_quat a);

/* v turned by a: within .5 ULP + |v| 2^-26. Saturates. */
qtri_vec3 qtri_quat_rotate(qtri_quat a, qtri_vec3 v);

/*
 * Between a (t = 0) and b (t = 1) along the shortest arc; t is clamped to 0..1. The ends are a and
 * b or -b, normalised. a and b half a turn of the quaternion apart (b = -a) are the same
 * orientation: it stays. nlerp moves faster in the middle; slerp at a constant angular speed.
 */
qtri_quat qtri_quat_nlerp(qtri_quat a, qtri_quat b, q16 t);
qtri_quat qtri_quat_slerp(qtri_quat a, qtri_quat b, q16 t);

/*
 * a after dt seconds of turning at a rate, in degrees a second about the axes of the body itself,
 * as a gyroscope on it measures: a exp(rate dt / 2), normalised. A step of more than 65535 degrees
 * counts as that. Turns of less than 1/600 degree a step are lost: an attitude keeps 10^-7.
 */
qtri_quat qtri_quat_integrate_deg(qtri_quat a, qtri_vec3 rate, q16 dt);

/* An orientation that is integrated: qtri_quat_integrate_deg with 30 bits. */
typedef struct qtri_attitude {
    int32_t q_q30[4]; /* w, x, y, z of a unit quaternion */
} qtri_attitude;

/* From a quaternion of any length, back to one, and on by dt seconds. */
qtri_attitude qtri_attitude_from_quat(qtri_quat a);
qtri_quat qtri_attitude_quat(const qtri_attitude *attitude);
void qtri_attitude_integrate_deg(qtri_attitude *attitude, qtri_vec3 rate, q16 dt);

/*
 * The attitude of a body from its gyroscope and its accelerometer, without their drift and noise:
 * the explicit complementary filter of Mahony, Hamel and Pflimlin, "Nonlinear complementary filters
 * on the special orthogonal group", IEEE Transactions on Automatic Control 53, 2008.
 *
 * Rates are integrated. Where the world's up in the attitude and in the accelerometer differ by an
 * angle a about some axis, the attitude turns about it towards the accelerometer at gain * sin a
 * radians a second, and the gyroscope's offset is learned at offset_gain * sin a radians a second
 * each second; with an offset_gain of 0 a constant offset leaves a constant error of offset / gain.
 * Turns about the vertical show in the gyroscope only: heading drifts.
 *
 * Axes of the body and its sensors are those of the renderer: x right, y up, z to the rear; the
 * world's y is up. Offset and correction are at most 128 degrees a second about an axis, gains
 * count up to +-571. Everything between is 2^-24 degrees a second and 2^-30 of the attitude.
 */
typedef struct qtri_attitude_filter {
    qtri_attitude attitude; /* body to world */
    int32_t offset_q24[3];  /* what is added to the rates, degrees a second in 2^-24 */
    q16 gain;               /* 1/s: 1 / time constant; .1 to 2 are usual */
    q16 offset_gain;        /* 1/s^2; gain^2 / 4 does not overshoot, 0: complementary */
    q16 tolerance;          /* g: a force further from 1 than this is not taken for gravity */
} qtri_attitude_filter;

/* Level, heading along -z, no offset, tolerance .15 g. All fields may be set afterwards. */
void qtri_attitude_filter_init(qtri_attitude_filter *filter, q16 gain, q16 offset_gain);

/*
 * One sample further, dt seconds in 2^-30: (1 << 30) / samples a second. The rate is in degrees a
 * second, the force in g: of the body on its support, (0, 1, 0) when it lies level. dt below 0 goes
 * back; a step turns by 65535 degrees at most.
 */
void qtri_attitude_filter_step(qtri_attitude_filter *filter, qtri_vec3 rate, qtri_vec3 force,
                               int32_t dt_q30);

#ifdef __cplusplus
}
#endif

#endif
