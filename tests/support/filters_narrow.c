/* SPDX-License-Identifier: MIT */
/*
 * The filter of pairs of pixels as for cores with few registers: edges are found one by one.
 */
#define QTRI_LONG_MULTIPLY 0

#define qtri_fxaa narrow_fxaa

#include "filter/fxaa.c"
