/* SPDX-License-Identifier: MIT */
/*
 * The polynomials that sine and cosine share. Internal.
 */
#ifndef QTRI_MATH_EIGHTHS_H
#define QTRI_MATH_EIGHTHS_H

#include <stdint.h>

/* w in Q31 is the distance from a right angle in eighths of a turn, up to 1. */
uint32_t qtri_sine_of_eighths_q30(uint32_t w);
uint32_t qtri_cosine_of_eighths_q30(uint32_t w);

#endif
