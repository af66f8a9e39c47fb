/* SPDX-License-Identifier: MIT */
/*
 * The worst error of pow below 64, found and not met by luck: 2^63 pairs are too many to try.
 *
 * pow(x, y) = 2^t with t = y log2(x). Just below t = 6 the core's logarithm of x, off by d, makes
 * the result y d ln 2 of 64 wrong, whatever else y is: 6 d / log2(x) ln 2, or less where y would
 * not fit. So d, found for each x, bounds the error of all y with that x; the power of
 * two adds at most POWER_ERROR. Where both cannot reach .515 no y is tried, and all y down to
 * where they cannot are otherwise: no pair that is not tried has a larger error. (The quick mode
 * leaves out errors below .5172.)
 */
#include "verify.h"

#include <math.h>

/* The core's own code under another name, for the logarithm inside it. */
#define q16_exp  verify_q16_exp
#define q16_exp2 verify_q16_exp2
#define q16_log  verify_q16_log
#define q16_log2 verify_q16_log2
#define q16_pow  verify_q16_pow
q16 q16_exp(q16 x);
q16 q16_exp2(q16 x);
q16 q16_log(q16 x);
q16 q16_log2(q16 x);
q16 q16_pow(q16 x, q16 y);
#include "../../core/math/q16_exp.c" /* NOLINT(bugprone-suspicious-include) */
#undef q16_exp
#undef q16_exp2
#undef q16_log
#undef q16_log2
#undef q16_pow

/* ULP. The power of two is within 3.3 2^-32 of 1 + p where 2^21 (1 + p) is the result. */
#define POWER_ERROR .0017

#define TOP_LOG 6.0 /* results end at 2^6 */
#define TOP     (64 * 65536.0)

/* How wrong pow can be for an x just below t = 6 by the error of its logarithm, in ULP. */
static double log_error(uint32_t x, double log)
{
    double off = (double)precise_log2_q43(x) * 0x1p-43 - log;
    double most = fmin(fabs(TOP_LOG / log), 32768); /* of |y| */
    return fabs(off) * most * 0.69314718 * TOP * exp2(fabs(log) * most - TOP_LOG);
}

/* From the largest result down, while its error may still be `searched`. */
static void try_powers(q16 x, double log, double error, double searched, verify_row *row)
{
    const int64_t most = (int64_t)(fmin(fabs(TOP_LOG / log), 32768) * 65536);
    for (int64_t size = most < INT32_MAX ? most + 1 : INT32_MAX; size > 0; size--) {
        const q16 pair[2] = {x, (q16)(log < 0 ? -size : size)};
        double exact = (double)(65536 * powl(x / 65536.0L, pair[1] / 65536.0L));
        double at_most = .5 + (error * (double)size / (double)most + POWER_ERROR) * exact / TOP;
        if (at_most < searched) {
            return;
        }
        if (exact < TOP) {
            double wrong = fabs(verify_q16_pow(pair[0], pair[1]) - exact);
            verify_row_add(row, pair, 2, wrong, wrong <= .5);
        }
    }
}

/*
 * x below 8. Beyond, log2(x) is 3 or more and y 2 or less: the logarithm of the mantissa, at most
 * .5 and within 2^-29 of itself, makes .006 ULP.
 */
enum { CHUNK_BITS = 13, CHUNKS = 1 << (19 - CHUNK_BITS) };

static uint64_t power_chunks(const verify_test *test, const verify_options *options)
{
    (void)test;
    (void)options;
    return CHUNKS;
}

static void power_run(const verify_test *test, const verify_options *options, uint64_t chunk,
                      verify_row *rows)
{
    const double searched = options->mode == VERIFY_QUICK ? .5172 : .515;
    (void)test;
    for (uint32_t i = 0; i < (uint32_t)1 << CHUNK_BITS; i++) {
        uint32_t x = (uint32_t)(chunk << CHUNK_BITS) + i;
        if (x == 0 || x == 65536) {
            continue;
        }
        double log = log2(x / 65536.0);
        double error = log_error(x, log);
        if (.5 + error + POWER_ERROR > searched) {
            try_powers((q16)x, log, error, searched, &rows[0]);
        }
    }
}

const verify_test verify_power_test = {
    "pow_worst",
    power_run,
    power_chunks,
    NULL,
    {{"pow", "_worst", "pow < 64, errors >= .515", 2, .52, false}},
};
