/* SPDX-License-Identifier: MIT */
/*
 * Elementary functions, vectors, matrices and quaternions as a debug build has them. The scalars
 * are those of q16_checked.c; what the build would stop at is counted there.
 */
#ifndef QTRI_CHECK_MATH
#define QTRI_CHECK_MATH
#endif
#define QTRI_MATH_FAULT q16_checked_fault

#define q16_add                     checked_q16_add
#define q16_sub                     checked_q16_sub
#define q16_neg                     checked_q16_neg
#define q16_mul                     checked_q16_mul
#define q16_lerp                    checked_q16_lerp
#define q16_tan                     checked_q16_tan
#define q16_tan_deg                 checked_q16_tan_deg
#define q16_exp                     checked_q16_exp
#define q16_exp2                    checked_q16_exp2
#define q16_log                     checked_q16_log
#define q16_log2                    checked_q16_log2
#define q16_pow                     checked_q16_pow
#define q16_asin                    checked_q16_asin
#define q16_asin_deg                checked_q16_asin_deg
#define q16_acos                    checked_q16_acos
#define q16_acos_deg                checked_q16_acos_deg
#define q16_sin                     checked_q16_sin
#define q16_cos                     checked_q16_cos
#define q16_sincos                  checked_q16_sincos
#define q16_sin_deg                 checked_q16_sin_deg
#define q16_cos_deg                 checked_q16_cos_deg
#define q16_sincos_deg              checked_q16_sincos_deg
#define q16_atan                    checked_q16_atan
#define q16_atan_deg                checked_q16_atan_deg
#define q16_atan2                   checked_q16_atan2
#define q16_atan2_deg               checked_q16_atan2_deg
#define qtri_angle_q31              checked_qtri_angle_q31
#define qtri_half_turns_to_radians  checked_qtri_half_turns_to_radians
#define qtri_sine_of_eighths_q30    checked_qtri_sine_of_eighths_q30
#define qtri_cosine_of_eighths_q30  checked_qtri_cosine_of_eighths_q30
#define qtri_mul_q31                checked_qtri_mul_q31
#define qtri_series_q31             checked_qtri_series_q31
#define qtri_sincos_deg_q30         checked_qtri_sincos_deg_q30
#define qtri_quat_slerp             checked_qtri_quat_slerp
#define qtri_quat_nlerp             checked_qtri_quat_nlerp
#define qtri_side_angle_q31         checked_qtri_side_angle_q31
#define qtri_attitude_from_quat     checked_qtri_attitude_from_quat
#define qtri_attitude_quat          checked_qtri_attitude_quat
#define qtri_attitude_integrate_deg checked_qtri_attitude_integrate_deg
#define qtri_attitude_filter_init   checked_qtri_attitude_filter_init
#define qtri_attitude_filter_step   checked_qtri_attitude_filter_step
#define qtri_quat_integrate_deg     checked_qtri_quat_integrate_deg
#define qtri_dot                    checked_qtri_dot
#define qtri_dot_cross              checked_qtri_dot_cross
#define qtri_dot_rows               checked_qtri_dot_rows
#define qtri_vec2_dot               checked_qtri_vec2_dot
#define qtri_vec3_dot               checked_qtri_vec3_dot
#define qtri_vec4_dot               checked_qtri_vec4_dot
#define qtri_vec2_cross             checked_qtri_vec2_cross
#define qtri_vec3_cross             checked_qtri_vec3_cross
#define qtri_vec_distance           checked_qtri_vec_distance
#define qtri_vec_normalize          checked_qtri_vec_normalize
#define qtri_vec_along              checked_qtri_vec_along
#define qtri_wide_to_q16            checked_qtri_wide_to_q16
#define qtri_wide_less              checked_qtri_wide_less
#define qtri_wide_dot               checked_qtri_wide_dot
#define qtri_wide_invert            checked_qtri_wide_invert
#define qtri_mat3_determinant       checked_qtri_mat3_determinant
#define qtri_mat3_inverse           checked_qtri_mat3_inverse
#define qtri_mat3_mul               checked_qtri_mat3_mul
#define qtri_mat3_point             checked_qtri_mat3_point
#define qtri_mat3_reflect_deg       checked_qtri_mat3_reflect_deg
#define qtri_mat3_rotate_about_deg  checked_qtri_mat3_rotate_about_deg
#define qtri_mat3_rotate_deg        checked_qtri_mat3_rotate_deg
#define qtri_mat3_scale             checked_qtri_mat3_scale
#define qtri_mat3_shear             checked_qtri_mat3_shear
#define qtri_mat3_translate         checked_qtri_mat3_translate
#define qtri_mat3_transpose         checked_qtri_mat3_transpose
#define qtri_mat3_vec3              checked_qtri_mat3_vec3
#define qtri_mat3_vector            checked_qtri_mat3_vector
#define qtri_mat4_determinant       checked_qtri_mat4_determinant
#define qtri_mat4_inverse           checked_qtri_mat4_inverse
#define qtri_mat4_inverse_affine    checked_qtri_mat4_inverse_affine
#define qtri_mat4_normal_matrix     checked_qtri_mat4_normal_matrix
#define qtri_mat4_from_linear       checked_qtri_mat4_from_linear
#define qtri_mat4_linear            checked_qtri_mat4_linear
#define qtri_mat4_mul               checked_qtri_mat4_mul
#define qtri_mat4_point             checked_qtri_mat4_point
#define qtri_mat4_scale             checked_qtri_mat4_scale
#define qtri_mat4_shear             checked_qtri_mat4_shear
#define qtri_mat4_times             checked_qtri_mat4_times
#define qtri_mat4_translate         checked_qtri_mat4_translate
#define qtri_mat4_transpose         checked_qtri_mat4_transpose
#define qtri_mat4_vector            checked_qtri_mat4_vector
#define qtri_mat4_reflect           checked_qtri_mat4_reflect
#define qtri_quat_conjugate         checked_qtri_quat_conjugate
#define qtri_quat_dot               checked_qtri_quat_dot
#define qtri_quat_from_axis_deg     checked_qtri_quat_from_axis_deg
#define qtri_quat_from_euler_deg    checked_qtri_quat_from_euler_deg
#define qtri_quat_to_mat3           checked_qtri_quat_to_mat3
#define qtri_quat_to_mat4           checked_qtri_quat_to_mat4
#define qtri_quat_rotate            checked_qtri_quat_rotate
#define qtri_quat_from_q30          checked_qtri_quat_from_q30
#define qtri_quat_identity          checked_qtri_quat_identity
#define qtri_quat_inverse           checked_qtri_quat_inverse
#define qtri_quat_mul               checked_qtri_quat_mul
#define qtri_quat_normalize         checked_qtri_quat_normalize
#define qtri_quat_unit_q30          checked_qtri_quat_unit_q30
#define qtri_mat3_identity          checked_qtri_mat3_identity
#define qtri_mat4_identity          checked_qtri_mat4_identity
#define qtri_mat4_rotate_axis_deg   checked_qtri_mat4_rotate_axis_deg
#define qtri_mat4_rotate_about_deg  checked_qtri_mat4_rotate_about_deg
#define qtri_mat4_rotate_euler_deg  checked_qtri_mat4_rotate_euler_deg
#define qtri_mat4_rotate_x_deg      checked_qtri_mat4_rotate_x_deg
#define qtri_mat4_rotate_y_deg      checked_qtri_mat4_rotate_y_deg
#define qtri_mat4_rotate_z_deg      checked_qtri_mat4_rotate_z_deg
#define qtri_quat_from_mat3         checked_qtri_quat_from_mat3
#define qtri_quat_from_mat4         checked_qtri_quat_from_mat4
#define qtri_vec_angle_deg          checked_qtri_vec_angle_deg

#include "math/dot.c"
#include "math/mat.c"
#include "math/q16_exp.c"
#include "math/q16_trig.c"
#include "math/quat.c"
#include "math/vec.c"

#include "math_checked.h"

static const qtri_vec2 far2 = {Q16(30000), Q16(-30000)};
static const qtri_vec3 far3 = {Q16(30000), Q16(-30000), Q16(30000)};
static const qtri_vec4 far4 = {Q16(30000), Q16(-30000), Q16(30000), Q16(30000)};
static const qtri_vec2 near2 = {Q16(1), Q16(-2)};
static const qtri_vec3 near3 = {Q16(3), Q16(-4), Q16(5)};
static const qtri_vec4 near4 = {Q16(3), Q16(-4), Q16(5), Q16(6)};
static const qtri_vec3 least3 = {0, 0, Q16_MIN};
static const qtri_vec3 short3 = {1, 1, 2};
static const qtri_quat far_q = {Q16(30000), Q16(-30000), Q16(30000), Q16(30000)};
static const qtri_quat near_q = {Q16(1), Q16(-2), Q16(3), Q16(4)};
static const qtri_quat least_q = {0, 0, Q16_MIN, 0};
static const qtri_quat short_q = {1, 0, 0, 0};
static const qtri_mat3 far_m3 = {{{Q16(9000), 0, 0}, {0, Q16(9000), 0}, {0, 0, Q16(9000)}}};
static const qtri_mat3 near_m3 = {{{Q16(2), 0, 0}, {0, Q16(3), 0}, {0, 0, Q16(1)}}};
static const qtri_mat3 short_m3 = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
static const qtri_mat4 far_m4 = {
    {{Q16(9000), 0, 0, 0}, {0, Q16(9000), 0, 0}, {0, 0, Q16(9000), 0}, {0, 0, 0, Q16(9000)}}};
static const qtri_mat4 near_m4 = {
    {{Q16(2), 0, 0, 0}, {0, Q16(3), 0, 0}, {0, 0, Q16(1), 0}, {0, 0, 0, Q16(1)}}};
static const qtri_mat4 short_m4 = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
static qtri_mat3 m3;
static qtri_mat4 m4;

/* What has a result, what only the nearest that there is. clang-format would not keep the columns.
 */
/* clang-format off */
#define CASES(CASE) \
    CASE(tan, q16_tan(Q16(1)), (q16_checked_fault(), 0)) \
    CASE(tan_deg, q16_tan_deg(Q16(89)), q16_tan_deg(Q16(90))) \
    CASE(exp, q16_exp(Q16(10)), q16_exp(Q16(11))) \
    CASE(exp2, q16_exp2(Q16(14)), q16_exp2(Q16(15))) \
    CASE(log, q16_log(1), q16_log(0)) \
    CASE(log2, q16_log2(1), q16_log2(-1)) \
    CASE(pow, q16_pow(Q16(2), Q16(14)), q16_pow(Q16(2), Q16(15))) \
    CASE(pow_negative, q16_pow(Q16(-2), Q16(3)), q16_pow(Q16(-2), Q16(0.5))) \
    CASE(pow_zero, q16_pow(0, 1), q16_pow(0, -1)) \
    CASE(asin, q16_asin(Q16(-1)), q16_asin(Q16(-1.1))) \
    CASE(asin_deg, q16_asin_deg(Q16(1)), q16_asin_deg(Q16_MIN)) \
    CASE(acos, q16_acos(Q16(1)), q16_acos(Q16(1) + 1)) \
    CASE(acos_deg, q16_acos_deg(0), q16_acos_deg(Q16_MAX)) \
    CASE(vec2_add, qtri_vec2_add(near2, near2), qtri_vec2_add(far2, far2)) \
    CASE(vec2_scale, qtri_vec2_scale(near2, Q16(2)), qtri_vec2_scale(far2, Q16(2))) \
    CASE(vec2_dot, qtri_vec2_dot(near2, near2), qtri_vec2_dot(far2, far2)) \
    CASE(vec2_length, qtri_vec2_length(near2), qtri_vec2_length(far2)) \
    CASE(vec3_add, qtri_vec3_add(near3, near3), qtri_vec3_add(far3, far3)) \
    CASE(vec3_scale, qtri_vec3_scale(near3, Q16(2)), qtri_vec3_scale(far3, Q16(2))) \
    CASE(vec3_dot, qtri_vec3_dot(near3, near3), qtri_vec3_dot(far3, far3)) \
    CASE(vec3_length, qtri_vec3_length(near3), qtri_vec3_length(far3)) \
    CASE(vec4_add, qtri_vec4_add(near4, near4), qtri_vec4_add(far4, far4)) \
    CASE(vec4_scale, qtri_vec4_scale(near4, Q16(2)), qtri_vec4_scale(far4, Q16(2))) \
    CASE(vec4_dot, qtri_vec4_dot(near4, near4), qtri_vec4_dot(far4, far4)) \
    CASE(vec4_length, qtri_vec4_length(near4), qtri_vec4_length(far4)) \
    CASE(vec3_sub, qtri_vec3_sub(far3, far3), qtri_vec3_sub(near3, least3)) \
    CASE(vec3_neg, qtri_vec3_neg(far3), qtri_vec3_neg(least3)) \
    CASE(vec3_lerp, qtri_vec3_lerp(near3, far3, Q16(0.5)), qtri_vec3_lerp(near3, far3, Q16(2))) \
    CASE(vec2_cross, qtri_vec2_cross(near2, near2), qtri_vec2_cross(far2, (qtri_vec2){Q16(2), Q16(2)})) \
    CASE(vec3_cross, qtri_vec3_cross(near3, near3), qtri_vec3_cross(far3, near3)) \
    CASE(vec3_distance, qtri_vec3_distance(far3, far3), qtri_vec3_distance(far3, near3)) \
    CASE(vec3_project, qtri_vec3_project(near3, far3), qtri_vec3_project(far3, (qtri_vec3){Q16(1.5), Q16(-0.5), Q16(0.5)})) \
    CASE(vec3_reject, qtri_vec3_reject(far3, near3), (q16_checked_fault(), 0)) \
    CASE(vec3_reflect, qtri_vec3_reflect(near3, short3), qtri_vec3_reflect(least3, least3)) \
    CASE(vec3_normalize, qtri_vec3_normalize(far3), (q16_checked_fault(), 0)) \
    CASE(mat3_mul, qtri_mat3_mul(&near_m3, &near_m3), qtri_mat3_mul(&far_m3, &far_m3)) \
    CASE(mat3_determinant, qtri_mat3_determinant(&near_m3), qtri_mat3_determinant(&far_m3)) \
    CASE(mat3_inverse, qtri_mat3_inverse(&m3, &near_m3), qtri_mat3_inverse(&m3, &short_m3)) \
    CASE(mat4_mul, qtri_mat4_mul(&near_m4, &near_m4), qtri_mat4_mul(&far_m4, &far_m4)) \
    CASE(mat4_determinant, qtri_mat4_determinant(&near_m4), qtri_mat4_determinant(&far_m4)) \
    CASE(mat4_inverse, qtri_mat4_inverse(&m4, &near_m4), qtri_mat4_inverse(&m4, &short_m4)) \
    CASE(mat3_vec3, qtri_mat3_vec3(&near_m3, near3), qtri_mat3_vec3(&far_m3, far3)) \
    CASE(mat3_point, qtri_mat3_point(&near_m3, near2), qtri_mat3_point(&far_m3, far2)) \
    CASE(mat3_vector, qtri_mat3_vector(&near_m3, near2), qtri_mat3_vector(&far_m3, far2)) \
    CASE(mat3_rotate_about, qtri_mat3_rotate_about_deg(Q16(90), near2), qtri_mat3_rotate_about_deg(Q16(90), far2)) \
    CASE(mat4_vec4, qtri_mat4_vec4(&near_m4, near4), qtri_mat4_vec4(&far_m4, far4)) \
    CASE(mat4_point, qtri_mat4_point(&near_m4, near3), qtri_mat4_point(&far_m4, far3)) \
    CASE(mat4_vector, qtri_mat4_vector(&near_m4, near3), qtri_mat4_vector(&far_m4, far3)) \
    CASE(mat4_normal_matrix, qtri_mat4_normal_matrix(&m3, &near_m4), qtri_mat4_normal_matrix(&m3, &short_m4)) \
    CASE(mat4_inverse_affine, qtri_mat4_inverse_affine(&m4, &near_m4), qtri_mat4_inverse_affine(&m4, &short_m4)) \
    CASE(mat4_reflect, qtri_mat4_reflect(near4), qtri_mat4_reflect((qtri_vec4){1, 0, 0, Q16(30000)})) \
    CASE(quat_mul, qtri_quat_mul(near_q, near_q), qtri_quat_mul(far_q, far_q)) \
    CASE(quat_dot, qtri_quat_dot(near_q, near_q), qtri_quat_dot(far_q, far_q)) \
    CASE(quat_conjugate, qtri_quat_conjugate(far_q), qtri_quat_conjugate(least_q)) \
    CASE(quat_inverse, qtri_quat_inverse(far_q), qtri_quat_inverse(short_q)) \
    CASE(quat_rotate, qtri_quat_rotate(near_q, near3), qtri_quat_rotate(qtri_quat_from_axis_deg(near3, Q16(70)), far3)) \
    CASE(quat_normalize, qtri_quat_normalize(far_q), (q16_checked_fault(), 0))
/* clang-format on */

#define FUNCTIONS(name, sound, faulty)                                                             \
    static void sound_##name(void)                                                                 \
    {                                                                                              \
        (void)(sound);                                                                             \
    }                                                                                              \
    static void faulty_##name(void)                                                                \
    {                                                                                              \
        (void)(faulty);                                                                            \
    }
CASES(FUNCTIONS)

#define ENTRY(name, sound, faulty) {#name, sound_##name, faulty_##name},
const math_checked_case math_checked_cases[] = {CASES(ENTRY){NULL, NULL, NULL}};
