/* SPDX-License-Identifier: MIT */
/*
 * Numbers as text.
 */
#ifndef QTRI_HOST_IO_NUMBER_H
#define QTRI_HOST_IO_NUMBER_H

#include <stddef.h>
#include <stdint.h>

enum number_result {
    NUMBER_OK,
    NUMBER_MALFORMED,   /* not a decimal number, or characters around it */
    NUMBER_OUT_OF_RANGE /* a number, but the result cannot hold it */
};

/*
 * A decimal number, all `length` characters of it: sign, digits, fraction, exponent, in any
 * number of digits ("-12", ".5", "2.5E+4", "1e-3"; no nan, inf or hex). *value is the nearest
 * Q16.16, exactly, ties away from zero. Out of range: the rounded value lies outside
 * -32768 .. 32767.99998. *value is only written on NUMBER_OK.
 */
enum number_result number_parse_q16(const char *text, size_t length, int32_t *value);

/* An optionally signed decimal integer in minimum..maximum, both within +-10^17. */
enum number_result number_parse_integer(const char *text, size_t length, int64_t minimum,
                                        int64_t maximum, int64_t *value);

/*
 * A decimal number as above in double precision: correctly rounded for up to 15 digits and powers
 * of ten up to 22, else within 3 ULP. Out of range: beyond +-1e30.
 */
enum number_result number_parse_real(const char *text, size_t length, double *value);

/* What to say after the text of a number that was refused as Q16.16: "is not a number", ... */
const char *number_problem(enum number_result result);

#endif
