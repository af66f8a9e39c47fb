/* SPDX-License-Identifier: MIT */
/*
 * Between public quaternions and those of rotation.h. Internal.
 */
#ifndef QTRI_MATH_QUAT_Q30_H
#define QTRI_MATH_QUAT_Q30_H

#include "qtri/quat.h"

#include "rotation.h"

/* The unit quaternion along a, the identity for zero. */
void qtri_quat_unit_q30(int32_t out_q30[4], qtri_quat a);

qtri_quat qtri_quat_from_q30(const int32_t q_q30[4]);

#endif
