/*
 * Trigonometry in Q16.16.
 */
#ifndef QTRI_Q16_TRIG_H
#define QTRI_Q16_TRIG_H

#include "qtri/q16.h"

#ifdef __cplusplus
extern "C" {
#endif

/*
 * Sine and cosine of an angle in degrees. Multiples of 90 are exact, other results within
 * .51 ULP (all 2^32 arguments are checked in the long run of the tests).
 */
q16 q16_sin_deg(q16 degrees);
q16 q16_cos_deg(q16 degrees);
void q16_sincos_deg(q16 degrees, q16 *sine, q16 *cosine);

#ifdef __cplusplus
}
#endif

#endif
