/* SPDX-License-Identifier: MIT */
/*
 * References of the trigonometric functions and their inverses.
 */
#include "block.h"
#include "real.h"

ULP(sin, 65536 * sinl(raw / 65536))
ULP(cos, 65536 * cosl(raw / 65536))
ULP(sin_deg, 65536 * sinl(fmodl(raw, REAL_TURN) * (REAL_PI / 180 / 65536)))
ULP(cos_deg, 65536 * cosl(fmodl(raw, REAL_TURN) * (REAL_PI / 180 / 65536)))
ULP(asin, 65536 * asinl(raw / 65536))
ULP(acos, 65536 * acosl(raw / 65536))
ULP(atan, 65536 * atanl(raw / 65536))
ULP(asin_deg, asin_ulp(raw) * (180 / REAL_PI))
ULP(acos_deg, acos_ulp(raw) * (180 / REAL_PI))
ULP(atan_deg, atan_ulp(raw) * (180 / REAL_PI))

/* Scales: 1 in ULP; as large a multiple for angles in degrees, whose slopes are 57 times those. */
#define UNIT    65536.0
#define DEGREES (64 * 65536.0)
#define ALL     Q16_MIN, Q16_MAX, 0, 0, Q16_MIN

static const real_function sin_data = {mpfr_sin, sin_ulp, UNIT, false, false, ALL};
static const real_function cos_data = {mpfr_cos, cos_ulp, UNIT, false, false, ALL};
static const real_function sin_deg_data = {mpfr_sin, sin_deg_ulp, UNIT, true, false, ALL};
static const real_function cos_deg_data = {mpfr_cos, cos_deg_ulp, UNIT, true, false, ALL};
static const real_function atan_data = {mpfr_atan, atan_ulp, UNIT, false, false, ALL};
static const real_function atan_deg_data = {mpfr_atan, atan_deg_ulp, DEGREES, false, true, ALL};

/* Beyond -1 .. 1: as for the nearer of the two. */
static const real_function asin_data = {mpfr_asin, asin_ulp, UNIT,    false,  false,
                                        -65536,    65536,    -102944, 102944, Q16_MAX};
static const real_function acos_data = {mpfr_acos, acos_ulp, UNIT,   false, false,
                                        -65536,    65536,    205887, 0,     Q16_MAX};
static const real_function asin_deg_data = {mpfr_asin, asin_deg_ulp, DEGREES,  false,   true,
                                            -65536,    65536,        Q16(-90), Q16(90), Q16_MAX};
static const real_function acos_deg_data = {mpfr_acos, acos_deg_ulp, DEGREES,  false, true,
                                            -65536,    65536,        Q16(180), 0,     Q16_MAX};

#define FUNCTION(data)                                                                             \
    {                                                                                              \
        real_function_exact, real_function_fast, real_function_block, &(data)                      \
    }

const verify_reference verify_sin = FUNCTION(sin_data);
const verify_reference verify_cos = FUNCTION(cos_data);
const verify_reference verify_sin_deg = FUNCTION(sin_deg_data);
const verify_reference verify_cos_deg = FUNCTION(cos_deg_data);
const verify_reference verify_asin = FUNCTION(asin_data);
const verify_reference verify_acos = FUNCTION(acos_data);
const verify_reference verify_atan = FUNCTION(atan_data);
const verify_reference verify_asin_deg = FUNCTION(asin_deg_data);
const verify_reference verify_acos_deg = FUNCTION(acos_deg_data);
const verify_reference verify_atan_deg = FUNCTION(atan_deg_data);

/* --- the tangent: a quotient of the two, as it has poles */

typedef struct tangent_data {
    const real_function *sine, *cosine;
    real_function tangent;
} tangent_data;

static const tangent_data tan_data = {
    &sin_data, &cos_data, {mpfr_tan, NULL, UNIT, false, false, ALL}};
static const tangent_data tan_deg_data = {
    &sin_deg_data, &cos_deg_data, {mpfr_tan, NULL, UNIT, true, false, ALL}};

/*
 * sine and cosine are off by at most d = 2^-47, so their quotient t by at most d (1 + |t|) / (|c| -
 * d). Where that says nothing, MPFR does.
 */
static verify_value tangent_of(double sine, double cosine)
{
    const double d = 0x1p-47;
    const double room = fabs(cosine) - 2 * d;
    verify_value fast = {0, 1e15};
    if (room > 0) {
        double t = sine / cosine;
        fast.value = 65536 * t;
        fast.unsure = 65536 * (d * (1 + 2 * fabs(t)) / room);
    }
    return fast;
}

static verify_value tangent_fast(const void *data, const q16 *argument)
{
    const tangent_data *f = (const tangent_data *)data;
    long double raw = (long double)argument[0];
    return tangent_of((double)f->sine->ulp(raw) / 65536, (double)f->cosine->ulp(raw) / 65536);
}

static bool tangent_block(const void *data, q16 first, double *value, double *unsure)
{
    const tangent_data *f = (const tangent_data *)data;
    double under[VERIFY_BLOCK];
    verify_interpolate(f->sine->ulp, first, value);
    verify_interpolate(f->cosine->ulp, first, under);
    for (int i = 0; i < VERIFY_BLOCK; i++) {
        verify_value fast = tangent_of(value[i] / 65536, under[i] / 65536);
        value[i] = fast.value;
        unsure[i] = fast.unsure;
    }
    return true;
}

static verify_exact tangent_exact(const void *data, const q16 *argument)
{
    const tangent_data *f = (const tangent_data *)data;
    /* A pole, which only degrees can hit: as documented. */
    q16 rest = argument[0] % (REAL_TURN / 2);
    if (f->tangent.takes_degrees && (rest == Q16(90) || rest == Q16(-90))) {
        return real_whole(rest > 0 ? Q16_MAX : Q16_MIN);
    }
    return real_function_exact(&f->tangent, argument);
}

const verify_reference verify_tan = {tangent_exact, tangent_fast, tangent_block, &tan_data};
const verify_reference verify_tan_deg = {tangent_exact, tangent_fast, tangent_block, &tan_deg_data};

/* --- atan2(y, x); atan2(0, 0) = 0 */

static const bool radians = false;
static const bool degrees = true;

static verify_exact atan2_exact(const void *data, const q16 *a)
{
    if (a[0] == 0 && a[1] == 0) {
        return real_whole(0);
    }
    mpfr_t y;
    mpfr_t x;
    mpfr_inits2(REAL_PRECISION, y, x, (mpfr_ptr)0);
    real_set(y, a[0]);
    real_set(x, a[1]);
    mpfr_atan2(y, y, x, MPFR_RNDN);
    if (*(const bool *)data == degrees) {
        real_to_degrees(y);
    }
    verify_exact exact = real_exact(y);
    mpfr_clears(y, x, (mpfr_ptr)0);
    return exact;
}

static verify_value atan2_fast(const void *data, const q16 *a)
{
    double angle = 65536 * atan2((double)a[0], (double)a[1]);
    if (*(const bool *)data == degrees) {
        return real_trusted(angle * (double)(180 / REAL_PI), DEGREES);
    }
    return real_trusted(angle, UNIT);
}

const verify_reference verify_atan2 = {atan2_exact, atan2_fast, NULL, &radians};
const verify_reference verify_atan2_deg = {atan2_exact, atan2_fast, NULL, &degrees};
