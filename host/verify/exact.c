/* SPDX-License-Identifier: MIT */
/*
 * References by integers alone: the rounded result is decided without floating point, which only
 * expresses how far the exact value is from it.
 */
#include "reference.h"

#include <math.h>

static int64_t sign_of(int128 x)
{
    return (x > 0) - (x < 0);
}

static verify_exact whole(int64_t value)
{
    verify_exact exact = {value, 0};
    return exact;
}

/* What division by zero gives: Q16_MAX, Q16_MIN or 0 by the sign of the numerator. */
static verify_exact by_zero(int128 numerator)
{
    return whole(sign_of(numerator) > 0 ? Q16_MAX : (sign_of(numerator) < 0 ? Q16_MIN : 0));
}

/* |numerator| < 2^110, and a quotient that does not fit is only known to be too large. */
static int64_t bounded(int128 x)
{
    const int128 bound = (int128)1 << 62;
    return (int64_t)(x > bound ? bound : (x < -bound ? -bound : x));
}

/* numerator / denominator; halves away from zero. */
static verify_exact quotient(int128 numerator, int128 denominator)
{
    if (denominator == 0) {
        return by_zero(numerator);
    }
    int128 n = numerator < 0 ? -numerator : numerator;
    int128 d = denominator < 0 ? -denominator : denominator;
    int128 nearest;
    if (n >> 63 == 0 && d >> 63 == 0) { /* the same, 64 bits being faster */
        uint64_t n64 = (uint64_t)n;
        uint64_t d64 = (uint64_t)d;
        uint64_t floor64 = n64 / d64;
        uint64_t rest = n64 - floor64 * d64;
        nearest = floor64 + (rest >= d64 - rest);
    } else {
        nearest = (2 * n + d) / (2 * d);
    }
    verify_exact exact = {bounded(nearest), (double)(n - nearest * d) / (double)d};
    if ((numerator < 0) != (denominator < 0)) {
        exact.nearest = -exact.nearest;
        exact.delta = -exact.delta;
    }
    return exact;
}

/* x / 2^16, rounded down. */
static verify_exact shifted_down(int128 x)
{
    int128 below = x >> 16;
    verify_exact exact = {bounded(below), (double)(x - below * 65536) / 65536.0};
    return exact;
}

/* x / 2^16; halves up. */
static verify_exact shifted(int128 x)
{
    int128 nearest = (x + 32768) >> 16;
    verify_exact exact = {bounded(nearest), (double)(x - nearest * 65536) / 65536.0};
    return exact;
}

/* The root of an integer is never halfway between two. */
static verify_exact root(uint64_t x)
{
    uint64_t r = (uint64_t)sqrt((double)x);
    while ((int128)r * r > (int128)x) {
        r--;
    }
    while ((int128)(r + 1) * (r + 1) <= (int128)x) {
        r++;
    }
    r += x - r * r > r; /* (r + 1/2)^2 = r^2 + r + 1/4 */
    double rest = (double)(int64_t)(x - r * r);
    verify_exact exact = {(int64_t)r, 0};
    if (rest != 0) {
        exact.delta = rest / (sqrt((double)x) + (double)r);
    }
    return exact;
}

static int64_t floor_of(int64_t x)
{
    return (x >> 16) * 65536;
}

/*
 * 2^24 / sqrt(x): the largest r with r^2 x <= 2^48, then up when (2r + 1)^2 x < 2^50. A half would
 * need an odd square that divides a power of two.
 */
static verify_exact inverse_root(q16 a)
{
    if (a <= 0) {
        return whole(Q16_MAX);
    }
    int128 x = a;
    int64_t r = (int64_t)(16777216.0 / sqrt((double)a));
    while ((int128)r * r * x > (int128)1 << 48) {
        r--;
    }
    while ((int128)(r + 1) * (r + 1) * x <= (int128)1 << 48) {
        r++;
    }
    r += (int128)(2 * r + 1) * (2 * r + 1) * x < (int128)1 << 50;
    /* d with (r + d)^2 x = 2^48: d = (2^48 - r^2 x) / (x (2r + d)), and x (2r + d) = 2^24 sqrt(x) +
     * r x. */
    double rest = (double)(((int128)1 << 48) - (int128)r * r * x);
    double slope = 16777216.0 * sqrt((double)x) + (double)r * (double)x;
    verify_exact exact = {r, rest / slope};
    return exact;
}

/* a - b floor(a / b), with the sign of b; b = 0 gives a. */
static int64_t remainder_of(int64_t a, int64_t b)
{
    if (b == 0) {
        return a;
    }
    int64_t rest = a % b;
    return rest != 0 && (rest < 0) != (b < 0) ? rest + b : rest;
}

/* --- the references: of arguments a[0], a[1] ... */

#define EXACT(name, value)                                                                         \
    static verify_exact exact_##name(const void *data, const q16 *a)                               \
    {                                                                                              \
        (void)data;                                                                                \
        return value;                                                                              \
    }                                                                                              \
    const verify_reference verify_##name = {exact_##name, NULL, NULL, NULL};

EXACT(neg, whole(-(int64_t)a[0]))
EXACT(abs, whole(a[0] < 0 ? -(int64_t)a[0] : a[0]))
EXACT(floor, whole(floor_of(a[0])))
EXACT(ceil, whole(floor_of((int64_t)a[0] + 65535)))
EXACT(round, whole(floor_of((int64_t)a[0] + 32768))) /* halves up */
EXACT(fract, whole(a[0] - floor_of(a[0])))
EXACT(recip, quotient((int128)1 << 32, a[0]))
EXACT(sqrt, a[0] <= 0 ? whole(0) : root((uint64_t)a[0] << 16))
EXACT(rsqrt, inverse_root(a[0]))
EXACT(add, whole((int64_t)a[0] + a[1]))
EXACT(sub, whole((int64_t)a[0] - a[1]))
EXACT(mul, shifted((int128)a[0] * a[1]))
EXACT(mul_floor, shifted_down((int128)a[0] * a[1]))
EXACT(div, quotient((int128)a[0] * 65536, a[1]))
EXACT(mod, whole(remainder_of(a[0], a[1])))
EXACT(hypot, root((uint64_t)((int64_t)a[0] * a[0]) + (uint64_t)((int64_t)a[1] * a[1])))
EXACT(muldiv, quotient((int128)a[0] * a[1], a[2]))
EXACT(lerp, shifted((int128)a[0] * 65536 + ((int128)a[1] - a[0]) * a[2]))
