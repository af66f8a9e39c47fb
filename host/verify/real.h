/* SPDX-License-Identifier: MIT */
/*
 * What the transcendental references are made of. Internal to them.
 */
#ifndef QTRI_VERIFY_REAL_H
#define QTRI_VERIFY_REAL_H

#include "reference.h"

#include <math.h>
#include <mpfr.h>

#define REAL_PI 3.141592653589793238462643383279502884L

enum {
    REAL_PRECISION = 200, /* bits of MPFR */
    REAL_TURN = 360 * 65536
};

/* y, in units, as the nearest multiple of an ULP and the rest; halves away from zero. Changes y. */
verify_exact real_exact(mpfr_t y);
verify_exact real_whole(int64_t value);

void real_set(mpfr_t x, q16 raw);

/* x 180 / pi. */
void real_to_degrees(mpfr_t x);

/* A value in ULP from libm, trusted to 2^-48 of itself or of the scale, whichever is larger. */
verify_value real_trusted(long double value, double scale);
verify_value real_certain(double value);

/* A function of one argument. `ulp` takes raw Q16.16, also between two of them, and gives ULP. */
typedef struct real_function {
    int (*mpfr)(mpfr_ptr y, mpfr_srcptr x, mpfr_rnd_t rounding);
    long double (*ulp)(long double raw);
    double scale; /* of `trusted` */
    bool takes_degrees, gives_degrees;
    /* Beyond these arguments the result is constant: as documented, or saturated. */
    q16 low, high;
    int32_t below, above;
    q16 smooth_from; /* smallest argument whose neighbourhood verify_interpolate may take */
} real_function;

/* The `ulp` of one: NAME_ulp, which makes ULP of `raw`. */
#define ULP(name, value)                                                                           \
    static long double name##_ulp(long double raw)                                                 \
    {                                                                                              \
        return value;                                                                              \
    }

/* The members of a verify_reference whose data is a real_function. */
verify_exact real_function_exact(const void *data, const q16 *argument);
verify_value real_function_fast(const void *data, const q16 *argument);
bool real_function_block(const void *data, q16 first, double *value, double *unsure);

#endif
