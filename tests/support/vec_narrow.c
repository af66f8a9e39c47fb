/* SPDX-License-Identifier: MIT */
/*
 * Vectors, matrices and quaternions compiled for a core without a long multiply.
 */
#define QTRI_LONG_MULTIPLY 0

#define qtri_quat_nlerp             narrow_quat_nlerp
#define qtri_quat_slerp             narrow_quat_slerp
#define qtri_attitude_from_quat     narrow_attitude_from_quat
#define qtri_attitude_quat          narrow_attitude_quat
#define qtri_attitude_integrate_deg narrow_attitude_integrate_deg
#define qtri_attitude_filter_init   narrow_attitude_filter_init
#define qtri_attitude_filter_step   narrow_attitude_filter_step
#define qtri_quat_integrate_deg     narrow_quat_integrate_deg
#define qtri_wide_to_q16            narrow_wide_to_q16
#define qtri_wide_less              narrow_wide_less
#define qtri_wide_dot               narrow_wide_dot
#define qtri_wide_invert            narrow_wide_invert
#define qtri_dot                    narrow_dot
#define qtri_dot_cross              narrow_dot_cross
#define qtri_dot_rows               narrow_dot_rows
#define qtri_align32                narrow_align32
#define qtri_fit32                  narrow_fit32
#define qtri_unit                   narrow_unit
#define qtri_vec2_cross             narrow_vec2_cross
#define qtri_vec2_dot               narrow_vec2_dot
#define qtri_vec3_cross             narrow_vec3_cross
#define qtri_vec3_dot               narrow_vec3_dot
#define qtri_vec4_dot               narrow_vec4_dot
#define qtri_vec_distance           narrow_vec_distance
#define qtri_vec_normalize          narrow_vec_normalize
#define qtri_mat4_from_linear       narrow_mat4_from_linear
#define qtri_mat4_linear            narrow_mat4_linear
#define qtri_mat4_mul               narrow_mat4_mul
#define qtri_mat4_point             narrow_mat4_point
#define qtri_mat4_scale             narrow_mat4_scale
#define qtri_mat4_shear             narrow_mat4_shear
#define qtri_mat4_times             narrow_mat4_times
#define qtri_mat4_translate         narrow_mat4_translate
#define qtri_mat4_transpose         narrow_mat4_transpose
#define qtri_mat4_vector            narrow_mat4_vector
#define qtri_quat_mul               narrow_quat_mul
#define qtri_mat3_translate         narrow_mat3_translate
#define qtri_mat3_scale             narrow_mat3_scale
#define qtri_mat3_shear             narrow_mat3_shear
#define qtri_mat3_rotate_about_deg  narrow_mat3_rotate_about_deg
#define qtri_mat3_rotate_deg        narrow_mat3_rotate_deg
#define qtri_mat3_reflect_deg       narrow_mat3_reflect_deg
#define qtri_mat3_vec3              narrow_mat3_vec3
#define qtri_mat3_point             narrow_mat3_point
#define qtri_mat3_vector            narrow_mat3_vector
#define qtri_mat3_mul               narrow_mat3_mul
#define qtri_mat3_transpose         narrow_mat3_transpose
#define qtri_mat3_identity          narrow_mat3_identity
#define qtri_mat4_identity          narrow_mat4_identity
#define qtri_mat3_determinant       narrow_mat3_determinant
#define qtri_mat4_determinant       narrow_mat4_determinant
#define qtri_mat3_inverse           narrow_mat3_inverse
#define qtri_mat4_inverse           narrow_mat4_inverse
#define qtri_mat4_inverse_affine    narrow_mat4_inverse_affine
#define qtri_mat4_normal_matrix     narrow_mat4_normal_matrix
#define qtri_mat4_reflect           narrow_mat4_reflect
#define qtri_mat4_rotate_axis_deg   narrow_mat4_rotate_axis_deg
#define qtri_mat4_rotate_about_deg  narrow_mat4_rotate_about_deg
#define qtri_mat4_rotate_euler_deg  narrow_mat4_rotate_euler_deg
#define qtri_mat4_rotate_x_deg      narrow_mat4_rotate_x_deg
#define qtri_mat4_rotate_y_deg      narrow_mat4_rotate_y_deg
#define qtri_mat4_rotate_z_deg      narrow_mat4_rotate_z_deg
#define qtri_quat_identity          narrow_quat_identity
#define qtri_quat_unit_q30          narrow_quat_unit_q30
#define qtri_quat_from_q30          narrow_quat_from_q30
#define qtri_quat_conjugate         narrow_quat_conjugate
#define qtri_quat_dot               narrow_quat_dot
#define qtri_quat_normalize         narrow_quat_normalize
#define qtri_quat_inverse           narrow_quat_inverse
#define qtri_quat_from_axis_deg     narrow_quat_from_axis_deg
#define qtri_quat_from_euler_deg    narrow_quat_from_euler_deg
#define qtri_quat_to_mat3           narrow_quat_to_mat3
#define qtri_quat_to_mat4           narrow_quat_to_mat4
#define qtri_quat_rotate            narrow_quat_rotate
#define qtri_quat_from_mat3         narrow_quat_from_mat3
#define qtri_quat_from_mat4         narrow_quat_from_mat4
#define qtri_vec_along              narrow_vec_along
#define qtri_vec_angle_deg          narrow_vec_angle_deg

#include "math/dot.c"
#include "math/mat.c"
#include "math/quat.c"
#include "math/unit.c"
#include "math/vec.c"
