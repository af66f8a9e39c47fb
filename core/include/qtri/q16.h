/* SPDX-License-Identifier: MIT */
/*
 * Q16.16 scalars: an int32_t that counts 1/65536. Range [-32768, 32767.99998], resolution 1.5e-5.
 *
 * Every function is defined for every argument. Results round to nearest and saturate to
 * Q16_MIN..Q16_MAX; the name says so when a function does something else. An ULP is 1/65536,
 * "correctly rounded" means the q16 nearest to the exact result: an error of at most .5 ULP.
 * Exact halves go up, and away from zero in quotients.
 *
 * Source of every correctly rounded quotient and root: an estimate and the exact remainder, which
 * decides the last bit (Muller et al., Handbook of Floating-Point Arithmetic, 2nd ed., 4.7, 5.4).
 *
 * QTRI_CHECK_MATH, defined when core/ and the application are compiled, makes a debug build that
 * stops at what is likely a mistake: a result that had to be saturated, a division by zero, an
 * argument outside the domain given below. It calls QTRI_MATH_FAULT, which may be defined as the
 * name of a `void function(void)`; by default it is a trap instruction. If that function returns,
 * the result is the documented one. Where an overflow is meant, the name says so and nothing is
 * reported: q16_add_wrap() and its like keep the low 32 bits, q16_add_sat() and its like saturate.
 * The to_int conversions, floor and fract have no overflow to report.
 */
#ifndef QTRI_Q16_H
#define QTRI_Q16_H

#include <stddef.h>
#include <stdint.h>

#include "error.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A Q16.16 number: counts 1/65536. */
typedef int32_t q16;

/* 1, and the ends of the range. */
#define Q16_ONE ((q16)65536)
#define Q16_MAX ((q16)INT32_MAX)
#define Q16_MIN ((q16)INT32_MIN)

/* ---- Conversions ---- */

/*
 * A constant, rounded to nearest: Q16(0.5), Q16(-3). The literal must lie in the range above; the
 * compiler folds it to an integer, in double: where that has 24 bits, as with avr-gcc, a constant
 * from 128 up may be off by 2^-23 of itself. GCC and Clang refuse a variable, which would be
 * floating point: q16_from_int, q16_from_ratio and q16_from_fixed take these.
 */
#define Q16(literal)                                                                               \
    ((q16)((literal)*65536.0 + (QTRI_BELOW_0(literal) ? -0.5 : 0.5)) * QTRI_LITERAL(literal))

/* As an integer: tcc takes no comparison of floating-point numbers for a constant. */
#define QTRI_BELOW_0(literal) ((int64_t)((literal)*4294967296.0) < 0)

/* 1 where the compiler knows the value; does not compile otherwise. */
#if defined(__GNUC__) && !defined(__cplusplus)
#define QTRI_LITERAL(x) ((q16) __builtin_choose_expr(__builtin_constant_p(x), 1, (void)0))
#elif defined(__GNUC__)
#define QTRI_LITERAL(x) ((q16)sizeof(char[__builtin_constant_p(x) ? 1 : -1]))
#else
#define QTRI_LITERAL(x) ((q16)1)
#endif

/* x as an integer is out of range from 32768 up and below -32768: saturates. Otherwise exact. */
q16 q16_from_int(int32_t x);

/* numerator / denominator, correctly rounded. Denominator 0: as q16_div. */
q16 q16_from_ratio(int32_t numerator, int32_t denominator);

/*
 * Integers, -32768..32768: largest <= x; smallest >= x; nearest, halves up; x without its fraction.
 */
static inline int32_t q16_to_int_floor(q16 x)
{
    return x >> 16;
}

static inline int32_t q16_to_int_ceil(q16 x)
{
    return (x >> 16) + ((x & 0xFFFF) != 0);
}

static inline int32_t q16_to_int_round(q16 x)
{
    return (x >> 16) + ((x >> 15) & 1);
}

static inline int32_t q16_to_int_trunc(q16 x)
{
    return x / 65536;
}

/*
 * From and to any other fixed-point format: `value` counts 2^-fraction_bits. Correctly rounded,
 * halves up; saturates. fraction_bits may be any number, negative ones count multiples of 2.
 */
q16 q16_from_fixed(int32_t value, int fraction_bits);
int32_t q16_to_fixed(q16 x, int fraction_bits);

/* Q2.30, for x in [-2, 2); Q24.8. As above. */
static inline q16 q16_from_q30(int32_t x_q30)
{
    return (x_q30 >> 14) + ((x_q30 >> 13) & 1);
}

static inline int32_t q16_to_q30(q16 x)
{
    return q16_to_fixed(x, 30);
}

static inline q16 q16_from_q8(int32_t x_q8)
{
    return q16_from_fixed(x_q8, 8);
}

static inline int32_t q16_to_q8(q16 x)
{
    return (x >> 8) + ((x >> 7) & 1);
}

/* ---- Sums ---- */

/* Exact where they fit. -Q16_MIN and |Q16_MIN| are Q16_MAX. */
q16 q16_add(q16 a, q16 b);
q16 q16_sub(q16 a, q16 b);
q16 q16_neg(q16 x);
q16 q16_abs(q16 x);

/* The low 32 bits of the sum: wraps around, which is meant. -Q16_MIN is Q16_MIN. */
static inline q16 q16_add_wrap(q16 a, q16 b)
{
    return (q16)((uint32_t)a + (uint32_t)b);
}

static inline q16 q16_sub_wrap(q16 a, q16 b)
{
    return (q16)((uint32_t)a - (uint32_t)b);
}

static inline q16 q16_neg_wrap(q16 x)
{
    return (q16)(0u - (uint32_t)x);
}

/* a + (b - a) t, rounded once, halves up: .5 ULP. t is not clamped, and b - a cannot overflow. */
q16 q16_lerp(q16 a, q16 b, q16 t);

/* ---- Products and quotients ---- */

/* a b. Correctly rounded, halves up. */
q16 q16_mul(q16 a, q16 b);

/* a b, rounded towards minus infinity. */
q16 q16_mul_floor(q16 a, q16 b);

/* a b as q16_mul rounds it, but of a result that does not fit the low 32 bits. */
q16 q16_mul_wrap(q16 a, q16 b);

/* a / b. Correctly rounded, halves away from zero. b = 0: Q16_MAX, Q16_MIN or 0 by a's sign. */
q16 q16_div(q16 a, q16 b);

/* a b / c with the whole product. Rounded as q16_div, and for c = 0 as q16_div(a b, 0). */
q16 q16_muldiv(q16 a, q16 b, q16 c);

/* 1 / x. Rounded as q16_div. x = 0 gives Q16_MAX; from |x| <= 2/65536 it saturates. */
q16 q16_recip(q16 x);

/* a - b floor(a / b): in [0, b) for b > 0 and in (b, 0] for b < 0. Exact. b = 0 gives a. */
q16 q16_mod(q16 a, q16 b);

/* ---- Roots ---- */

/* Square root. x in [0, 32768); x < 0 gives 0. Correctly rounded; halves do not occur. */
q16 q16_sqrt(q16 x);

/* 1 / sqrt(x), at most 256. x <= 0 gives Q16_MAX. Correctly rounded; halves do not occur. */
q16 q16_rsqrt(q16 x);

/* sqrt(a^2 + b^2). Correctly rounded, nothing on the way overflows; the result saturates. */
q16 q16_hypot(q16 a, q16 b);

/* ---- Choosing and rounding ---- */

/* The smaller, and the larger one of a and b. */
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

/* -1, 0 or 1 as a q16. */
static inline q16 q16_sign(q16 x)
{
    return x > 0 ? Q16_ONE : -(x < 0) * Q16_ONE;
}

/* The largest integer <= x. Exact. */
static inline q16 q16_floor(q16 x)
{
    return x - (x & 0xFFFF);
}

/* x - floor(x), in [0, 1). Exact. */
static inline q16 q16_fract(q16 x)
{
    return x & 0xFFFF;
}

/* The smallest integer >= x; the nearest, halves up. 32768 does not fit and gives Q16_MAX. */
q16 q16_ceil(q16 x);
q16 q16_round(q16 x);

/* ---- Overflow that is meant ---- */

/* The same results; QTRI_CHECK_MATH does not report that they saturate. */
q16 q16_add_sat(q16 a, q16 b);
q16 q16_sub_sat(q16 a, q16 b);
q16 q16_mul_sat(q16 a, q16 b);
q16 q16_div_sat(q16 a, q16 b);

/* ---- Trigonometry, in radians as in <math.h> and in degrees, where right angles are exact ---- */

/*
 * From here on errors are against the exact value, .5 of them being the rounding to a result,
 * maxima over all arguments (tests/test_core_elementary.c names the worst ones). Odd and even
 * functions are so to the last bit, for Q16_MIN with the angle 32768 it stands for.
 */

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

/* ---- Exponentials and logarithms ---- */

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

/* ---- Decimal text: no libc, no locale, the decimal sign is '.' ---- */

/* Characters that any number needs, with the NUL: "-32767.99998". */
#define QTRI_Q16_TEXT_SIZE 13

/*
 * Reads an optional sign, digits and an optional '.' with digits, at least one digit in all, from
 * the start of the text: "2", "-.5", "+3.", "1.70710678". No blanks before it and no exponent:
 * what follows the number is the caller's to judge. Any number of digits is rounded once, to
 * nearest, halves away from zero.
 *
 * Returns how many characters were read, and stores the number. Text that does not begin with
 * one gives 0 and leaves *out alone. A number beyond the range (-32768.000007..32767.999992 round
 * into it) stores Q16_MIN or Q16_MAX and gives QTRI_ERROR_SIZE.
 */
int32_t q16_from_string(const char *text, q16 *out);

/*
 * Writes the shortest decimal that q16_from_string reads as x again, of those with as many digits
 * the nearest: "0.1", "-1.5", "3", "0.00002". At most five digits behind the point.
 *
 * Returns the length without the NUL. A buffer too small for the text and its NUL gives
 * QTRI_ERROR_MEMORY and holds an empty string, if it has room for that.
 */
int32_t q16_to_string(q16 x, char *buffer, size_t size);

#ifdef __cplusplus
}
#endif

#endif
