/* SPDX-License-Identifier: MIT */
/*
 * The elementary functions compiled for a core without a long multiply.
 */
#define QTRI_LONG_MULTIPLY 0

#define q16_sin                    narrow_sin
#define q16_cos                    narrow_cos
#define q16_sincos                 narrow_sincos
#define q16_sin_deg                narrow_sin_deg
#define q16_cos_deg                narrow_cos_deg
#define q16_sincos_deg             narrow_sincos_deg
#define q16_tan                    narrow_tan
#define q16_tan_deg                narrow_tan_deg
#define q16_asin                   narrow_asin
#define q16_asin_deg               narrow_asin_deg
#define q16_acos                   narrow_acos
#define q16_acos_deg               narrow_acos_deg
#define q16_atan                   narrow_atan
#define q16_atan_deg               narrow_atan_deg
#define q16_atan2                  narrow_atan2
#define q16_atan2_deg              narrow_atan2_deg
#define q16_exp                    narrow_exp
#define q16_exp2                   narrow_exp2
#define q16_log                    narrow_log
#define q16_log2                   narrow_log2
#define q16_pow                    narrow_pow
#define qtri_angle_q31             narrow_angle_q31
#define qtri_half_turns_to_radians narrow_half_turns_to_radians
#define qtri_side_angle_q31        narrow_side_angle_q31
#define qtri_sine_of_eighths_q30   narrow_sine_of_eighths_q30
#define qtri_cosine_of_eighths_q30 narrow_cosine_of_eighths_q30
#define qtri_mul_q31               narrow_mul_q31
#define qtri_series_q31            narrow_series_q31
#define qtri_sincos_deg_q30        narrow_sincos_deg_q30

#include "math/q16_trig.c"
#include "math/q16_exp.c"

#include "elementary.h"

const elementary_build elementary_narrow_build = ELEMENTARY_BUILD;
