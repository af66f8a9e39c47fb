/* SPDX-License-Identifier: MIT */
/*
 * Rotations at 30 fraction bits: unit quaternions w, x, y, z and their matrices. Internal.
 */
#ifndef QTRI_MATH_ROTATION_H
#define QTRI_MATH_ROTATION_H

#include "qtri/mat.h"
#include "qtri/quat.h"

/* Sine and cosine of an angle in Q32 degrees, |angle| < 2^15 degrees: within 2^-29. */
void qtri_sincos_deg_q32(int64_t degrees_q32, int32_t *sine_q30, int32_t *cosine_q30);

/* About an axis of any length; a zero axis gives the identity. */
void qtri_rotation_axis(int32_t out_q30[4], qtri_vec3 axis, q16 degrees);
void qtri_rotation_euler(int32_t out_q30[4], qtri_vec3 degrees, qtri_euler order);

/* out = a b; out may be a or b. */
void qtri_rotation_mul(int32_t out_q30[4], const int32_t a_q30[4], const int32_t b_q30[4]);

/* For a unit quaternion. */
void qtri_rotation_matrix(int32_t out_q30[3][3], const int32_t q_q30[4]);
qtri_mat3 qtri_rotation_mat3(const int32_t q_q30[4]);

/* ---- Public quaternions ---- */

/* The unit quaternion along a, the identity for zero. */
void qtri_quat_unit_q30(int32_t out_q30[4], qtri_quat a);

qtri_quat qtri_quat_from_q30(const int32_t q_q30[4]);

#endif
