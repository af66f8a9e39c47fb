/* SPDX-License-Identifier: MIT */
/*
 * The power of two that exp and pow share. Internal.
 */
#ifndef QTRI_MATH_EXP2_H
#define QTRI_MATH_EXP2_H

#include "qtri/q16.h"

/* 2^(factor log) for a log in [-16, 16) in Q43; errors as q16_exp. */
q16 qtri_exp2_product(q16 factor, int64_t log_q43);

#endif
