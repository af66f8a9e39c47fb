/* SPDX-License-Identifier: MIT */
/*
 * `exact` asks MPFR for 200 bits: a value has at most 31 before the point, and among 2^32 inputs
 * (or 2^34 pairs) none can be expected within 2^-100 of a tie without being one. `fast` asks libm
 * for long double; what it is trusted with would hold for double, too.
 */
#include "block.h"
#include "real.h"

static const double trust = 0x1p-48;

verify_exact real_whole(int64_t value)
{
    verify_exact exact = {value, 0};
    return exact;
}

verify_exact real_exact(mpfr_t y)
{
    mpfr_mul_2ui(y, y, 16, MPFR_RNDN);
    if (mpfr_cmp_d(y, 0x1p50) > 0 || mpfr_cmp_d(y, -0x1p50) < 0) {
        return real_whole(mpfr_sgn(y) > 0 ? (int64_t)1 << 50 : -((int64_t)1 << 50));
    }
    mpfr_t nearest;
    mpfr_init2(nearest, REAL_PRECISION);
    mpfr_round(nearest, y);
    mpfr_sub(y, y, nearest, MPFR_RNDN);
    verify_exact exact = {(int64_t)mpfr_get_d(nearest, MPFR_RNDN), mpfr_get_d(y, MPFR_RNDN)};
    mpfr_clear(nearest);
    return exact;
}

void real_set(mpfr_t x, q16 raw)
{
    mpfr_set_si_2exp(x, raw, -16, MPFR_RNDN);
}

static void to_radians(mpfr_t x)
{
    mpfr_t pi;
    mpfr_init2(pi, REAL_PRECISION);
    mpfr_const_pi(pi, MPFR_RNDN);
    mpfr_mul(x, x, pi, MPFR_RNDN);
    mpfr_div_ui(x, x, 180, MPFR_RNDN);
    mpfr_clear(pi);
}

void real_to_degrees(mpfr_t x)
{
    mpfr_t pi;
    mpfr_init2(pi, REAL_PRECISION);
    mpfr_const_pi(pi, MPFR_RNDN);
    mpfr_mul_ui(x, x, 180, MPFR_RNDN);
    mpfr_div(x, x, pi, MPFR_RNDN);
    mpfr_clear(pi);
}

verify_value real_trusted(long double value, double scale)
{
    const long double large = 1e15L; /* beyond any result, and its bound still is a number */
    value = value > large ? large : (value < -large ? -large : value);
    verify_value fast = {(double)value, 0};
    fast.unsure = (fabs(fast.value) + scale) * trust;
    return fast;
}

verify_value real_certain(double value)
{
    verify_value fast = {value, 0};
    return fast;
}

verify_exact real_function_exact(const void *data, const q16 *argument)
{
    const real_function *f = (const real_function *)data;
    q16 raw = argument[0];
    if (raw < f->low || raw > f->high) {
        return real_whole(raw < f->low ? f->below : f->above);
    }
    mpfr_t x;
    mpfr_init2(x, REAL_PRECISION);
    real_set(x, f->takes_degrees ? raw % REAL_TURN : raw);
    if (f->takes_degrees) {
        to_radians(x);
    }
    (void)f->mpfr(x, x, MPFR_RNDN);
    if (f->gives_degrees) {
        real_to_degrees(x);
    }
    verify_exact exact = real_exact(x);
    mpfr_clear(x);
    return exact;
}

verify_value real_function_fast(const void *data, const q16 *argument)
{
    const real_function *f = (const real_function *)data;
    if (argument[0] < f->low || argument[0] > f->high) {
        return real_certain(argument[0] < f->low ? f->below : f->above);
    }
    return real_trusted(f->ulp((long double)argument[0]), f->scale);
}

bool real_function_block(const void *data, q16 first, double *value, double *unsure)
{
    const real_function *f = (const real_function *)data;
    if (first < f->smooth_from || first < f->low || first > f->high - (VERIFY_BLOCK - 1)) {
        return false;
    }
    verify_interpolate(f->ulp, first, value);
    for (int i = 0; i < VERIFY_BLOCK; i++) {
        unsure[i] = (fabs(value[i]) + f->scale) * trust;
    }
    return true;
}
