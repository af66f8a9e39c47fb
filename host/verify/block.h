/* SPDX-License-Identifier: MIT */
/*
 * Smooth functions over 1024 consecutive inputs, by interpolation.
 */
#ifndef QTRI_VERIFY_BLOCK_H
#define QTRI_VERIFY_BLOCK_H

#include "verify.h"

/*
 * The values of f (from raw Q16.16, in ULP) at first .. first + VERIFY_BLOCK - 1: the polynomial of
 * degree 6 through f at seven points of the interval. For the error see block.c.
 */
void verify_interpolate(long double (*f)(long double raw), q16 first, double *value);

#endif
