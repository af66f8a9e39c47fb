/*
 * Between public quaternions and those of rotation.h. Internal.
 */
#ifndef QTRI_MATH_QUAT_Q30_H
#define QTRI_MATH_QUAT_Q30_H

#include "qtri/quat.h"

#include "rotation.h"

qtri_quat qtri_quat_from_q30(const int32_t q_q30[4]);

#endif
