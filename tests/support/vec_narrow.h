/* SPDX-License-Identifier: MIT */
/*
 * What vec_narrow.c compiles for a core without a long multiply: the same results.
 */
#ifndef QTRI_TESTS_SUPPORT_VEC_NARROW_H
#define QTRI_TESTS_SUPPORT_VEC_NARROW_H

#include <qtri/quat.h>

q16 narrow_vec3_dot(qtri_vec3 a, qtri_vec3 b);
qtri_vec3 narrow_vec3_cross(qtri_vec3 a, qtri_vec3 b);
void narrow_vec_normalize(q16 *out, const q16 *a, int32_t count);
void narrow_mat4_times(q16 out[4], const qtri_mat4 *m, const q16 v[4]);
qtri_quat narrow_quat_mul(qtri_quat a, qtri_quat b);

#endif
