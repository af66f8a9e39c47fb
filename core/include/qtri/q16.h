/*
 * Q16.16 scalars: an int32_t that counts 1/65536. Range [-32768, 32767.99998], resolution 1.5e-5.
 *
 * Every function is defined for every argument. Results round to nearest (ties away from zero
 * where not said otherwise) and saturate to Q16_MIN..Q16_MAX; the name says so when a function
 * does something else.
 */
#ifndef QTRI_Q16_H
#define QTRI_Q16_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef int32_t q16;

#define Q16_ONE ((q16)65536)
#define Q16_MAX ((q16)INT32_MAX)
#define Q16_MIN ((q16)INT32_MIN)

/*
 * A constant, rounded to nearest: Q16(0.5), Q16(-3). The literal must lie in the range above; the
 * compiler folds it to an integer, no floating-point instruction remains.
 */
#define Q16(literal) ((q16)((literal)*65536.0 + ((literal) < 0 ? -0.5 : 0.5)))

/* x as an integer is out of range from 32768 up and below -32768: saturates. */
q16 q16_from_int(int32_t x);

/* numerator / denominator. Denominator 0: as q16_div. */
q16 q16_from_ratio(int32_t numerator, int32_t denominator);

/* Largest integer <= x; nearest integer, halves up. */
int32_t q16_to_int_floor(q16 x);
int32_t q16_to_int_round(q16 x);

q16 q16_add(q16 a, q16 b);
q16 q16_sub(q16 a, q16 b);
q16 q16_neg(q16 x); /* -Q16_MIN is Q16_MAX */
q16 q16_abs(q16 x); /* |Q16_MIN| is Q16_MAX */

static inline q16 q16_min(q16 a, q16 b)
{
    return a < b ? a : b;
}

static inline q16 q16_max(q16 a, q16 b)
{
    return a > b ? a : b;
}

/* x held within low..high; low > high gives high. */
static inline q16 q16_clamp(q16 x, q16 low, q16 high)
{
    return q16_min(q16_max(x, low), high);
}

/* a * b. Correctly rounded, halves up. */
q16 q16_mul(q16 a, q16 b);

/* a * b, rounded towards minus infinity. */
q16 q16_mul_floor(q16 a, q16 b);

/* a / b. Correctly rounded. b = 0 gives Q16_MAX, Q16_MIN or 0 by the sign of a. */
q16 q16_div(q16 a, q16 b);

/* a + (b - a) t, rounded once. t is not clamped. */
q16 q16_lerp(q16 a, q16 b, q16 t);

/* Square root. x < 0 gives 0. Correctly rounded. */
q16 q16_sqrt(q16 x);

#ifdef __cplusplus
}
#endif

#endif
