/* SPDX-License-Identifier: MIT */
/*
 * Exponentials and logarithms in Q16.16.
 *
 * Errors are against the exact value, .5 of them being the rounding to a result; the maxima are
 * those over all arguments (tests/test_core_elementary.c names the worst ones).
 */
#ifndef QTRI_Q16_EXP_H
#define QTRI_Q16_EXP_H

#include "qtri/q16.h"

#ifdef __cplusplus
extern "C" {
#endif

/*
 * 2^x and e^x. Below 2^-17 the result is 0, from 32768 up Q16_MAX. Within .69 and .92 ULP in the
 * whole range, and .51 while the result is below 128. Monotone. exp2 of a whole number is exact.
 * Degree-7 polynomial in the fraction of x; e^x = 2^(x log2 e).
 */
q16 q16_exp2(q16 x);
q16 q16_exp(q16 x);

/*
 * Logarithms to base 2 and e. x <= 0 gives Q16_MIN. Within .52 ULP. Monotone. log2 of a power of
 * two is exact. Sixteen table entries and a cubic (Tang 1990).
 */
q16 q16_log2(q16 x);
q16 q16_log(q16 x);

/*
 * x^y. Within .52 ULP while the result is below 64 (over all pairs, by a search that leaves out
 * only what cannot be worse) and 2^-22.8 of it beyond (tested, not over all pairs); saturates.
 *   y = 0              1, also for x = 0
 *   x = 0              0 for y > 0, Q16_MAX for y < 0
 *   x < 0, y whole     |x|^y with the sign of (-1)^y; at most Q16_MAX, at least Q16_MIN
 *   x < 0, otherwise   0: there is no real result
 */
q16 q16_pow(q16 x, q16 y);

#ifdef __cplusplus
}
#endif

#endif
