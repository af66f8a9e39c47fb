/* SPDX-License-Identifier: MIT */
/*
 * Trigonometry in Q16.16, in radians as in <math.h> and in degrees, where right angles are exact.
 *
 * Errors are against the exact value, .5 of them being the rounding to a result; the maxima are
 * those over all arguments (tests/test_core_elementary.c names the worst ones). Functions that are
 * odd or even are so to the last bit, for Q16_MIN with the angle 32768 it stands for.
 */
#ifndef QTRI_Q16_TRIG_H
#define QTRI_Q16_TRIG_H

#include "qtri/q16.h"

#ifdef __cplusplus
extern "C" {
#endif

/*
 * Sine and cosine of any angle, in [-1, 1], within .51 ULP. In degrees multiples of 90 are exact;
 * so is sin of 30, and angles whole turns apart have the same results to the bit. sincos gives the
 * same results in less time than both calls.
 * Minimax polynomials of degree 7 and 6 on an eighth of a turn.
 */
q16 q16_sin(q16 radians);
q16 q16_cos(q16 radians);
void q16_sincos(q16 radians, q16 *sine, q16 *cosine);
q16 q16_sin_deg(q16 degrees);
q16 q16_cos_deg(q16 degrees);
void q16_sincos_deg(q16 degrees, q16 *sine, q16 *cosine);

/*
 * Tangent, within .53 ULP while it is below 256 and 2^-24.9 of itself beyond; saturates to
 * Q16_MAX and Q16_MIN. Odd multiples of 90 degrees, where there is none, give Q16_MAX with the sign
 * of the argument: Q16_MIN for negative ones. In degrees all others repeat to the bit after 180.
 */
q16 q16_tan(q16 radians);
q16 q16_tan_deg(q16 degrees);

/*
 * The angle of the vector (x, y) from the x axis, in (-pi, pi] or (-180, 180]: y < 0 is negative,
 * y = 0 and x < 0 is half a turn. (0, 0) gives 0. Within .51 ULP, .52 in degrees; multiples of 45
 * degrees are exact. x and y may be in any one format, as only their ratio counts.
 * Quotient by Newton's method, polynomial of degree 9 around 0 and atan(1/2).
 */
q16 q16_atan2(q16 y, q16 x);
q16 q16_atan2_deg(q16 y, q16 x);

/* Arctangent, in [-pi/2, pi/2] or [-90, 90]: q16_atan2(x, 1). Monotone. Within .51 and .52 ULP. */
q16 q16_atan(q16 x);
q16 q16_atan_deg(q16 x);

/*
 * Arcsine in [-pi/2, pi/2] and arccosine in [0, pi], and in degrees; x beyond [-1, 1] is taken as
 * the nearer end. Within .51 ULP. The angle of the sides x and sqrt(1 - x^2).
 */
q16 q16_asin(q16 x);
q16 q16_acos(q16 x);
q16 q16_asin_deg(q16 x);
q16 q16_acos_deg(q16 x);

#ifdef __cplusplus
}
#endif

#endif
