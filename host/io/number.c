/* SPDX-License-Identifier: MIT */
#include "number.h"

#include <math.h>
#include <stdbool.h>

#define FRACTION_DIGITS 17                          /* all that can matter, see to_q16 */
#define INTEGER_DIGITS  10                          /* more is far outside Q16.16 */
#define POWER_5_17      UINT64_C(762939453125)      /* 5^17 */
#define MAGNITUDE_LIMIT INT64_C(100000000000000000) /* 10^17: times 10 plus 9 still fits */

/* The parts of a number's text. */
struct decimal {
    const char *digits; /* digits and at most one point */
    const char *digits_end;
    int64_t integer_digits; /* how many stand before the point */
    int64_t exponent;       /* exact up to +-MAGNITUDE_LIMIT; beyond, as good as infinite */
    bool negative;
};

static bool is_digit(char c)
{
    return c >= '0' && c <= '9';
}

static const char *skip_sign(const char *p, const char *end, bool *negative)
{
    *negative = p < end && *p == '-';
    return p < end && (*p == '-' || *p == '+') ? p + 1 : p;
}

/* One digit or more and nothing else. Above MAGNITUDE_LIMIT *value only says "larger than that". */
static bool read_digits(const char *p, const char *end, int64_t *value)
{
    if (p == end) {
        return false;
    }
    *value = 0;
    for (; p < end; p++) {
        if (!is_digit(*p)) {
            return false;
        }
        if (*value <= MAGNITUDE_LIMIT) {
            *value = *value * 10 + (*p - '0');
        }
    }
    return true;
}

static const char *split_digits(const char *p, const char *end, struct decimal *out)
{
    bool point = false;
    bool any = false;
    out->digits = p;
    out->integer_digits = 0;
    for (; p < end; p++) {
        if (*p == '.' && !point) {
            point = true;
        } else if (is_digit(*p)) {
            any = true;
            out->integer_digits += point ? 0 : 1;
        } else {
            break;
        }
    }
    out->digits_end = p;
    return any ? p : NULL;
}

static bool split(const char *p, const char *end, struct decimal *out)
{
    p = split_digits(skip_sign(p, end, &out->negative), end, out);
    out->exponent = 0;
    if (p == NULL || p == end) {
        return p != NULL;
    }
    if (*p != 'e' && *p != 'E') {
        return false;
    }
    bool negative;
    p = skip_sign(p + 1, end, &negative);
    if (!read_digits(p, end, &out->exponent)) {
        return false;
    }
    out->exponent = negative ? -out->exponent : out->exponent;
    return true;
}

static uint64_t digit_times_power_of_ten(char digit, int64_t power)
{
    uint64_t product = (uint64_t)(digit - '0');
    for (; power > 0; power--) {
        product *= 10;
    }
    return product;
}

/*
 * |x| = I + F / 10^17 + rest, where rest < 10^-17. The values at which rounding to Q16.16 changes
 * its mind are odd multiples of 2^-17, which have 17 decimal places: the rest decides nothing, and
 *     floor(|x| 2^17) = I 2^17 + floor(F 2^17 / 10^17) = I 2^17 + floor(F / 5^17).
 * Half of that, rounded up, is the magnitude rounded to nearest with ties away from zero.
 */
static enum number_result to_q16(const struct decimal *decimal, int32_t *value)
{
    uint64_t integer = 0;                                        /* I < 10^10 */
    uint64_t fraction = 0;                                       /* F < 10^17 */
    int64_t power = decimal->integer_digits + decimal->exponent; /* of ten; of the digit before */
    for (const char *p = decimal->digits; p < decimal->digits_end; p++) {
        if (*p == '.') {
            continue;
        }
        power--;
        if (*p == '0' || power < -FRACTION_DIGITS) {
            continue;
        }
        if (power >= INTEGER_DIGITS) {
            return NUMBER_OUT_OF_RANGE;
        }
        if (power >= 0) {
            integer += digit_times_power_of_ten(*p, power);
        } else {
            fraction += digit_times_power_of_ten(*p, FRACTION_DIGITS + power);
        }
    }
    uint64_t doubled = (integer << 17) + fraction / POWER_5_17; /* < 2^51 */
    int64_t magnitude = (int64_t)((doubled + 1) / 2);
    int64_t result = decimal->negative ? -magnitude : magnitude;
    if (result < INT32_MIN || result > INT32_MAX) {
        return NUMBER_OUT_OF_RANGE;
    }
    *value = (int32_t)result;
    return NUMBER_OK;
}

enum number_result number_parse_q16(const char *text, size_t length, int32_t *value)
{
    struct decimal decimal;
    if (!split(text, text + length, &decimal)) {
        return NUMBER_MALFORMED;
    }
    return to_q16(&decimal, value);
}

/* 19 digits fit 64 bits; those that follow are below half a unit of a double's last place. */
static enum number_result to_real(const struct decimal *decimal, double *value)
{
    uint64_t mantissa = 0;
    int digits = 0;
    int64_t power = decimal->integer_digits + decimal->exponent; /* of ten; of the digit before */
    for (const char *p = decimal->digits; p < decimal->digits_end && digits < 19; p++) {
        if (*p != '.') {
            mantissa = mantissa * 10 + (uint64_t)(*p - '0');
            digits += mantissa != 0 ? 1 : 0;
            power--;
        }
    }
    if (mantissa == 0 || power < -400) {
        *value = 0.0;
        return NUMBER_OK;
    }
    if (power > 40) {
        return NUMBER_OUT_OF_RANGE;
    }
    double magnitude = power < 0 ? (double)mantissa / pow(10.0, (double)-power)
                                 : (double)mantissa * pow(10.0, (double)power);
    if (!(magnitude <= 1e30)) {
        return NUMBER_OUT_OF_RANGE;
    }
    *value = decimal->negative ? -magnitude : magnitude;
    return NUMBER_OK;
}

enum number_result number_parse_real(const char *text, size_t length, double *value)
{
    struct decimal decimal;
    if (!split(text, text + length, &decimal)) {
        return NUMBER_MALFORMED;
    }
    return to_real(&decimal, value);
}

enum number_result number_parse_integer(const char *text, size_t length, int64_t minimum,
                                        int64_t maximum, int64_t *value)
{
    const char *end = text + length;
    bool negative;
    int64_t parsed;
    if (!read_digits(skip_sign(text, end, &negative), end, &parsed)) {
        return NUMBER_MALFORMED;
    }
    parsed = negative ? -parsed : parsed;
    if (parsed < minimum || parsed > maximum) {
        return NUMBER_OUT_OF_RANGE;
    }
    *value = parsed;
    return NUMBER_OK;
}

const char *number_problem(enum number_result result)
{
    switch (result) {
    case NUMBER_MALFORMED:
        return "is not a number";
    case NUMBER_OUT_OF_RANGE:
        return "does not fit Q16.16";
    case NUMBER_OK:
        break;
    }
    return "is a number";
}
