/* SPDX-License-Identifier: MIT */
/*
 * Vectors, matrices and quaternions compiled for a core without a long multiply.
 */
#define QTRI_LONG_MULTIPLY 0

#define qtri_dot              narrow_dot
#define qtri_dot_cross        narrow_dot_cross
#define qtri_dot_rows         narrow_dot_rows
#define qtri_fit32            narrow_fit32
#define qtri_unit             narrow_unit
#define qtri_vec2_cross       narrow_vec2_cross
#define qtri_vec2_dot         narrow_vec2_dot
#define qtri_vec3_cross       narrow_vec3_cross
#define qtri_vec3_dot         narrow_vec3_dot
#define qtri_vec4_dot         narrow_vec4_dot
#define qtri_vec_distance     narrow_vec_distance
#define qtri_vec_normalize    narrow_vec_normalize
#define qtri_mat4_from_linear narrow_mat4_from_linear
#define qtri_mat4_linear      narrow_mat4_linear
#define qtri_mat4_mul         narrow_mat4_mul
#define qtri_mat4_point       narrow_mat4_point
#define qtri_mat4_scale       narrow_mat4_scale
#define qtri_mat4_shear       narrow_mat4_shear
#define qtri_mat4_times       narrow_mat4_times
#define qtri_mat4_translate   narrow_mat4_translate
#define qtri_mat4_transpose   narrow_mat4_transpose
#define qtri_mat4_vector      narrow_mat4_vector
#define qtri_quat_mul         narrow_quat_mul

#include "math/dot.c"
#include "math/mat4.c"
#include "math/quat_mul.c"
#include "math/unit.c"
#include "math/vec.c"
