/* SPDX-License-Identifier: MIT */
/*
 * References of the exponential functions and their inverses.
 */
#include "real.h"

ULP(exp, 65536 * expl(raw / 65536))
ULP(exp2, 65536 * exp2l(raw / 65536))
ULP(log, 65536 * logl(raw / 65536))
ULP(log2, 65536 * log2l(raw / 65536))

/* exp saturates from log(32768) = 10.397, and -17 log(2) = -11.78 gives half an ULP: below that, 0.
 */
static const real_function exp_data = {mpfr_exp, exp_ulp, 0, false,   false,
                                       Q16(-12), Q16(11), 0, Q16_MAX, Q16_MAX};
static const real_function exp2_data = {mpfr_exp2, exp2_ulp, 0, false,   false,
                                        Q16(-18),  Q16(15),  0, Q16_MAX, Q16_MAX};

/* Zero and below: Q16_MIN. */
static const real_function log_data = {mpfr_log, log_ulp, 65536,   false, false,
                                       1,        Q16_MAX, Q16_MIN, 0,     65536};
static const real_function log2_data = {mpfr_log2, log2_ulp, 65536,   false, false,
                                        1,         Q16_MAX,  Q16_MIN, 0,     65536};

const verify_reference verify_exp = {real_function_exact, real_function_fast, NULL, &exp_data};
const verify_reference verify_exp2 = {real_function_exact, real_function_fast, NULL, &exp2_data};
const verify_reference verify_log = {real_function_exact, real_function_fast, real_function_block,
                                     &log_data};
const verify_reference verify_log2 = {real_function_exact, real_function_fast, real_function_block,
                                      &log2_data};

/* --- pow */

/* What is not a power of a positive number; true where *result says what is documented. */
static bool special_power(q16 x, q16 y, int64_t *result)
{
    if (y == 0) {
        *result = 65536;
    } else if (x == 0) {
        *result = y > 0 ? 0 : Q16_MAX;
    } else if (x < 0 && (y & 65535) != 0) {
        *result = 0;
    } else {
        return false;
    }
    return true;
}

static verify_exact pow_exact(const void *data, const q16 *a)
{
    (void)data;
    int64_t special;
    if (special_power(a[0], a[1], &special)) {
        return real_whole(special);
    }
    mpfr_t x;
    mpfr_t y;
    mpfr_inits2(REAL_PRECISION, x, y, (mpfr_ptr)0);
    real_set(x, a[0]);
    real_set(y, a[1]);
    mpfr_pow(x, x, y, MPFR_RNDN);
    verify_exact exact = real_exact(x);
    mpfr_clears(x, y, (mpfr_ptr)0);
    return exact;
}

static verify_value pow_fast(const void *data, const q16 *a)
{
    (void)data;
    int64_t special;
    if (special_power(a[0], a[1], &special)) {
        return real_certain((double)special);
    }
    double power = 65536 * pow((double)a[0] / 65536, (double)a[1] / 65536);
    return real_trusted(power, 0);
}

const verify_reference verify_pow = {pow_exact, pow_fast, NULL, NULL};
